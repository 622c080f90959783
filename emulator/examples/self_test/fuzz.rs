//! Damages what goes to the running image, and holds that it does what a robot does that hears the same.

use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant};

use bica_emulator::{Carrier, Emulator, bits};
use bica_field::GoalColour;
use bica_wire::message::{Chunk, Pace, Picture, Sensors};
use bica_wire::{Frame, FromRobot, Losses, MAX_PACKET, Receiver, Sender, ToRobot, chunks};

use crate::random::Random;
use crate::trials;
use crate::twin::Twin;

/// Bytes of the largest image that the microcontroller takes.
const IMAGE: usize = 2 * 160 * 120;

/// A robot on this computer that hears what the one in the emulator hears.
struct Model {
    receiver: Receiver<MAX_PACKET>,
    frame: Box<Frame<IMAGE>>,
    twin: Twin,
    /// Every command, with its time.
    commands: Vec<(u64, Vec<u32>)>,
    /// Packets, as they were when the last sensors came.
    losses: Losses,
}

/// Damages for so long; tells what was done.
///
/// # Errors
/// If the robot accepts what nobody sent, passes over what came whole, miscounts, panics or falls silent.
pub(crate) fn run(image: &Path, carrier: Carrier, time: Duration, seed: u64) -> Result<String, Box<dyn Error>> {
    let mut robot = trials::begin(image, carrier, Pace::Lockstep)?;
    let mut model = Model {
        receiver: Receiver::new(),
        frame: Box::new(Frame::new()),
        twin: Twin::new(GoalColour::Yellow),
        commands: Vec::new(),
        losses: Losses::default(),
    };
    let hello = trials::hello(Pace::Lockstep);
    let first = Sender::new().pack(&hello, &mut [0; MAX_PACKET])?.to_vec();
    model.hear(&first, &[hello])?;
    let (mut random, began) = (Random::new(seed), Instant::now());
    let (mut bytes, mut commands, mut rounds) = (0, 0, 0);
    let with_images = carrier != Carrier::Serial;
    while began.elapsed() < time {
        let (sent, commanded) = round(&mut robot, &mut model, &mut random, with_images)?;
        (bytes, commands, rounds) = (bytes + sent, commands + commanded, rounds + 1);
    }
    let Losses { whole, damaged, missing } = model.losses;
    let torn = model.frame.torn();
    Ok(format!(
        "{bytes} bytes in {rounds} damaged streams, {whole} packets whole, {damaged} damaged, {missing} missing, \
         {torn} images torn, {commands} commands, every one the host's"
    ))
}

impl Model {
    /// Hears bytes; what it accepts has to be one of the messages that were sent.
    fn hear(&mut self, bytes: &[u8], sent: &[ToRobot<'_>]) -> Result<(), Box<dyn Error>> {
        for &byte in bytes {
            let losses = self.receiver.losses();
            let Some(heard) = self.receiver.push(byte) else { continue };
            let message = heard.read::<ToRobot<'_>>()?;
            if !sent.contains(&message) {
                return Err(format!("accepted {message:?}, which nobody sent").into());
            }
            match message {
                ToRobot::Chunk(chunk) => self.frame.add(&chunk),
                ToRobot::Sensors(sensors) => {
                    let yuyv = sensors.picture.as_ref().and_then(|picture| self.frame.take(picture));
                    let command = self.twin.think(sensors.time_us, &sensors.sensed(yuyv));
                    self.commands.push((sensors.time_us, bits(&command).collect()));
                    self.losses = losses;
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// One stream, damaged, and one packet after it that is whole; how many bytes and commands went over the line.
fn round(
    robot: &mut Emulator,
    model: &mut Model,
    random: &mut Random,
    with_images: bool,
) -> Result<(usize, usize), Box<dyn Error>> {
    let mut yuyv = vec![random.next() as u8; IMAGE];
    let noise = random.below(IMAGE);
    yuyv[noise..].iter_mut().for_each(|byte| *byte = random.next() as u8);
    let mut messages = messages(random, with_images.then_some(&yuyv));
    let mouth = robot.line().halves().1;
    let mut stream = Vec::new();
    for message in &messages {
        if random.below(20) == 0 {
            mouth.lose();
        }
        stream.extend(mouth.pack(message)?);
    }
    damage(random, &mut stream);
    let last = sensors(random, None);
    messages.push(ToRobot::Sensors(last));
    stream.push(0);
    stream.extend(mouth.pack(&ToRobot::Sensors(last))?);
    model.hear(&stream, &messages)?;
    robot.line().write(&stream)?;
    let wanted = std::mem::take(&mut model.commands);
    compare(robot, &wanted, last.time_us, (model.frame.torn(), model.losses))?;
    Ok((stream.len(), wanted.len()))
}

/// Hears all that the robot says up to the telemetry of a time.
fn compare(
    robot: &mut Emulator,
    wanted: &[(u64, Vec<u32>)],
    until: u64,
    counted: (u32, Losses),
) -> Result<(), Box<dyn Error>> {
    let mut commands = Vec::new();
    let told = robot.line().hear(|message| match message {
        FromRobot::Command(command) => {
            let obeyed = command.obeyed().map(|command| bits(&command).collect());
            commands.push((command.time_us, obeyed.unwrap_or_default()));
            None
        }
        FromRobot::Greeting(greeting) => Some(Err(format!("it started anew: {}", greeting.reason))),
        FromRobot::Telemetry(telemetry) if telemetry.time_us == until => Some(Ok((telemetry.torn, telemetry.losses))),
        _ => None,
    })??;
    if commands != wanted {
        let times = |list: &[(u64, Vec<u32>)]| list.iter().map(|command| command.0).collect::<Vec<_>>();
        return Err(format!("commands for {:?}, wanted for {:?}", times(&commands), times(wanted)).into());
    }
    trials::same(&told, &counted)
}

fn messages<'a>(random: &mut Random, image: Option<&'a Vec<u8>>) -> Vec<ToRobot<'a>> {
    let mut messages = Vec::new();
    for _ in 0..=random.below(3) {
        let picture = Picture { image: random.next() as u32, bottom: false, width: 160, height: 120 };
        if let Some(yuyv) = image.filter(|_| random.below(3) == 0) {
            messages.extend(chunks(picture.image, yuyv).map(ToRobot::Chunk));
            messages.push(ToRobot::Sensors(sensors(random, Some(picture))));
        } else {
            let bytes: &[u8] = image.map_or(&[7; 20], |yuyv| &yuyv[..random.below(1025)]);
            messages.push(ToRobot::Chunk(Chunk { image: picture.image, at: random.below(IMAGE) as u32, bytes }));
            messages.push(ToRobot::Sensors(sensors(random, None)));
        }
    }
    messages
}

/// A robot that stands or does not; a time that none other has.
fn sensors(random: &mut Random, picture: Option<Picture>) -> Sensors {
    let mut sensors = Sensors { picture, ..trials::sensors(random.next() >> 24) };
    sensors.angles.iter_mut().for_each(|angle| *angle += random.within(0.3));
    sensors.inertial.iter_mut().for_each(|value| *value += random.within(1.0));
    sensors
}

/// Flips, removes, doubles, inserts and cuts.
fn damage(random: &mut Random, stream: &mut Vec<u8>) {
    for _ in 0..=random.below(8) {
        let place = random.below(stream.len());
        let end = (place + random.below(40)).min(stream.len());
        match random.below(7) {
            0 => stream[place..end].iter_mut().for_each(|byte| *byte ^= random.next() as u8),
            1 => drop(stream.drain(place..end)),
            2 => stream.splice(place..place, (0..random.below(20)).map(|_| 0)).for_each(drop),
            3 => stream.extend_from_within(place..end),
            4 if random.below(8) == 0 => stream.truncate(place),
            5 => stream.splice(place..place, (0..random.below(3000)).map(|at| at as u8 | 1)).for_each(drop),
            _ => stream.insert(place, random.next() as u8),
        }
    }
}
