//! Fuzzing of the link to the running image: on a damaged stream the image must behave like a model on the host.

use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant};

use bica_field::GoalColour;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player_program::emulator::{Emulator, SensorsMessage, Transport, command_bits, decode_command};
use bica_wire::message::{ClockMode, ImageChunk, LinkStats};
use bica_wire::{Decoder, Encoder, FromRobot, ImageBuffer, MAX_PACKET, ToRobot, blobs};

use crate::random::Random;
use crate::reference::Reference;
use crate::session::{self, hello, standing};

/// Size of the largest image that the microcontroller accepts, bytes.
const IMAGE_BYTES: usize = 2 * 160 * 120;

/// A robot on the host that receives the same bytes as the emulated one.
struct Model {
    decoder: Decoder<MAX_PACKET>,
    image: Box<ImageBuffer<IMAGE_BYTES>>,
    reference: Reference,
    /// Time and bits of each command since the last comparison.
    commands: Vec<(u64, Vec<u32>)>,
    /// Packet counts at the last sensor values.
    stats: LinkStats,
}

/// Damages the link for the given time and returns a summary.
///
/// # Errors
/// If the robot accepts a message that was not sent, misses an undamaged one, miscounts, panics or becomes silent.
pub(crate) fn run(image: &Path, transport: Transport, time: Duration, seed: u64) -> Result<String, Box<dyn Error>> {
    let mut robot = session::start(image, transport, ClockMode::Lockstep)?;
    let mut model = Model {
        decoder: Decoder::new(),
        image: Box::new(ImageBuffer::new()),
        reference: Reference::new(GoalColour::Yellow),
        commands: Vec::new(),
        stats: LinkStats::default(),
    };
    let hello = hello(ClockMode::Lockstep);
    let first = Encoder::new().encode(&hello, &mut [0; MAX_PACKET])?.to_vec();
    model.receive(&first, &[hello])?;
    let (mut random, start) = (Random::new(seed), Instant::now());
    let (mut bytes, mut commands, mut streams) = (0, 0, 0);
    let with_images = transport != Transport::Serial;
    while start.elapsed() < time {
        let (sent, commanded) = round(&mut robot, &mut model, &mut random, with_images)?;
        (bytes, commands, streams) = (bytes + sent, commands + commanded, streams + 1);
    }
    let LinkStats { received, damaged, missing } = model.stats;
    let incomplete = model.image.incomplete();
    Ok(format!(
        "{bytes} bytes in {streams} damaged streams, {received} packets received, {damaged} damaged, {missing} missing, \
         {incomplete} images incomplete, {commands} commands, each equal to the host's"
    ))
}

impl Model {
    /// Receives bytes. Each accepted message must be one of `sent`.
    fn receive(&mut self, bytes: &[u8], sent: &[ToRobot<'_>]) -> Result<(), Box<dyn Error>> {
        for &byte in bytes {
            let stats = self.decoder.stats();
            let Some(packet) = self.decoder.push(byte) else { continue };
            let message = packet.message::<ToRobot<'_>>()?;
            if !sent.contains(&message) {
                return Err(format!("accepted {message:?}, which was not sent").into());
            }
            match message {
                ToRobot::ImageChunk(chunk) => self.image.add(&chunk),
                ToRobot::Sensors(sensors) => {
                    let yuyv = sensors.blobs.as_ref().and_then(|info| self.image.take(info)).unwrap_or_default();
                    let values = blobs::decode(sensors.values, yuyv).ok_or("sensor values that cannot be read")?;
                    let command = self.reference.cycle(sensors.time_us, &values);
                    self.commands.push((sensors.time_us, command_bits(&command).collect()));
                    self.stats = stats;
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// Sends one damaged stream and one undamaged packet after it. Returns the number of bytes and of commands.
fn round(
    robot: &mut Emulator,
    model: &mut Model,
    random: &mut Random,
    with_images: bool,
) -> Result<(usize, usize), Box<dyn Error>> {
    let mut yuyv = vec![random.next() as u8; IMAGE_BYTES];
    let noise = random.below(IMAGE_BYTES);
    yuyv[noise..].iter_mut().for_each(|byte| *byte = random.next() as u8);
    let rounds = rounds(random, with_images.then_some(&yuyv));
    let mut messages: Vec<_> = rounds.iter().flat_map(parts).collect();
    let tx = robot.link().halves().1;
    let mut stream = Vec::new();
    for message in &messages {
        if random.below(20) == 0 {
            tx.skip();
        }
        stream.extend(tx.encode(message)?);
    }
    random.damage(&mut stream);
    let last = sensors(random, None);
    messages.push(last.message());
    stream.push(0);
    stream.extend(tx.encode(&last.message())?);
    model.receive(&stream, &messages)?;
    robot.link().write(&stream)?;
    let expected = std::mem::take(&mut model.commands);
    compare(robot, &expected, last.time_us, (model.image.incomplete(), model.stats))?;
    Ok((stream.len(), expected.len()))
}

/// Receives all messages of the robot up to the telemetry of the time `until` and compares them with the expected ones.
fn compare(
    robot: &mut Emulator,
    expected: &[(u64, Vec<u32>)],
    until: u64,
    counts: (u32, LinkStats),
) -> Result<(), Box<dyn Error>> {
    let mut commands = Vec::new();
    let reported = robot.link().receive(|message| match message {
        FromRobot::Command(command) => {
            let bits = decode_command(&command).map(|command| command_bits(&command).collect());
            commands.push((command.time_us, bits.unwrap_or_default()));
            None
        }
        FromRobot::Identity(identity) => Some(Err(format!("the robot restarted: {}", identity.last_panic))),
        FromRobot::Telemetry(telemetry) if telemetry.time_us == until => {
            Some(Ok((telemetry.incomplete_images, telemetry.link)))
        }
        _ => None,
    })??;
    if commands != expected {
        let times = |list: &[(u64, Vec<u32>)]| list.iter().map(|command| command.0).collect::<Vec<_>>();
        return Err(format!("commands for {:?}, expected for {:?}", times(&commands), times(expected)).into());
    }
    session::expect_eq(&reported, &counts)
}

/// Returns the messages of a round.
fn parts<'a>((stray, sensors): &'a Round<'a>) -> Vec<ToRobot<'a>> {
    stray.map(ToRobot::ImageChunk).into_iter().chain(sensors.chunks()).chain([sensors.message()]).collect()
}

/// Sensor values with their image, preceded by an optional chunk of another image.
type Round<'a> = (Option<ImageChunk<'a>>, SensorsMessage);

fn rounds<'a>(random: &mut Random, image: Option<&'a Vec<u8>>) -> Vec<Round<'a>> {
    let mut rounds = Vec::new();
    for _ in 0..=random.below(3) {
        let id = random.next() as u32;
        if let Some(yuyv) = image.filter(|_| random.below(3) == 0) {
            let image = Image { camera: CameraId::Top, width: 160, height: 120, yuyv };
            rounds.push((None, sensors(random, Some(image)).numbered(id)));
        } else {
            let bytes: &[u8] = image.map_or(&[7; 20], |yuyv| &yuyv[..random.below(1025)]);
            let offset = random.below(IMAGE_BYTES) as u32;
            rounds.push((Some(ImageChunk { image_id: id, offset, bytes }), sensors(random, None)));
        }
    }
    rounds
}

/// Returns sensor values similar to those of a standing robot, at a random time that identifies them.
fn sensors(random: &mut Random, image: Option<Image<'_>>) -> SensorsMessage {
    let time_us = random.next() >> 24;
    let mut sensors = Sensors { image, ..standing() };
    sensors.angles.0.iter_mut().for_each(|angle| *angle += random.within(0.3));
    let inertial = &mut sensors.inertial;
    for axis in 0..3 {
        inertial.gyro[axis] += random.within(1.0);
        inertial.acceleration[axis] += random.within(1.0);
    }
    inertial.roll += random.within(1.0);
    inertial.pitch += random.within(1.0);
    SensorsMessage::new(time_us, &sensors, 0)
}
