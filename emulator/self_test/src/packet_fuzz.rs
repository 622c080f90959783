//! Fuzzing of encoder and decoder on the host: damaged streams cause no panic and no wrong message.

use std::error::Error;
use std::time::{Duration, Instant};

use bica_field::GoalColour;
use bica_motion::joints::JOINTS;
use bica_wire::message::{ClockMode, Command, Hello, ImageChunk, Sensors};
use bica_wire::{Decoder, Encoder, FromRobot, ImageBuffer, MAX_PACKET, ToRobot};
use serde::Serialize;

use crate::random::Random;

/// Fuzzes for a time and returns a summary.
///
/// # Errors
/// If a message is accepted that was not sent, or no message is accepted at all.
pub(crate) fn run(time: Duration, seed: u64) -> Result<String, Box<dyn Error>> {
    let (mut random, start) = (Random::new(seed), Instant::now());
    let (mut streams, mut accepted) = (0_u64, 0_u64);
    while start.elapsed() < time {
        for _ in 0..1000 {
            accepted += round(&mut random)?;
            streams += 1;
        }
    }
    if accepted == 0 {
        return Err(format!("no message accepted in {streams} streams").into());
    }
    Ok(format!("{streams} damaged streams, {accepted} messages accepted, each equal to one that was sent"))
}

/// Sends messages of both directions as one damaged stream. Returns the number of accepted messages.
fn round(random: &mut Random) -> Result<u64, Box<dyn Error>> {
    let content: Vec<u8> = (0..random.below(1025)).map(|_| random.next() as u8).collect();
    let (to_robot, from_robot) = messages(random, &content);
    let (mut encoder, mut stream) = (Encoder::new(), Vec::new());
    for message in &to_robot {
        append(&mut encoder, message, &mut stream)?;
    }
    for message in &from_robot {
        append(&mut encoder, message, &mut stream)?;
    }
    random.damage(&mut stream);
    let (mut decoder, mut image, mut accepted) = (Decoder::<MAX_PACKET>::new(), ImageBuffer::<4096>::new(), 0);
    for byte in stream {
        let Some(packet) = decoder.push(byte) else { continue };
        let (to, from) = (packet.message::<ToRobot<'_>>(), packet.message::<FromRobot<'_>>());
        let was_sent = to.as_ref().is_ok_and(|message| to_robot.contains(message))
            || from.as_ref().is_ok_and(|message| from_robot.contains(message));
        if !was_sent {
            return Err(format!("accepted {to:?} or {from:?}, which was not sent").into());
        }
        if let Ok(ToRobot::ImageChunk(chunk)) = to {
            image.add(&chunk);
        }
        accepted += 1;
    }
    Ok(accepted)
}

fn append(encoder: &mut Encoder, message: &impl Serialize, stream: &mut Vec<u8>) -> Result<(), Box<dyn Error>> {
    let mut buffer = [0; MAX_PACKET];
    stream.extend_from_slice(encoder.encode(message, &mut buffer)?);
    Ok(())
}

fn messages<'a>(random: &mut Random, content: &'a [u8]) -> (Vec<ToRobot<'a>>, Vec<FromRobot<'a>>) {
    let mut floats = || -> [f32; JOINTS] { core::array::from_fn(|_| random.below(2000) as f32 / 100.0 - 10.0) };
    let (angles, temperatures, currents, targets) = (floats(), floats(), floats(), floats());
    let sensors = Sensors {
        time_us: random.next(),
        angles,
        temperatures,
        currents,
        inertial: [0.0; 8],
        feet: [1.0; 8],
        buttons: [true; 3],
        image: None,
    };
    let hello = Hello { schema: random.next(), clock_mode: ClockMode::FreeRunning, attacks: GoalColour::SkyBlue };
    let chunk = ImageChunk { image_id: random.next() as u32, offset: random.next() as u32, bytes: content };
    let command =
        Command { time_us: random.next(), targets, stiffness: [0.5; JOINTS], lights: [0.0; 9], bottom_camera: false };
    (
        vec![ToRobot::Hello(hello), ToRobot::ImageChunk(chunk), ToRobot::Sensors(sensors)],
        vec![FromRobot::Command(command)],
    )
}
