//! Instructions for each camera image: its reception, and the cycles until the next image.

use std::error::Error;
use std::path::Path;

use bica_player_program::emulator::{Emulator, Transport};
use bica_sim::setup::Frame;
use bica_wire::message::ClockMode;
use bica_wire::{ToRobot, chunks};

use crate::game::Played;
use crate::images::CameraImage;
use crate::session::{self, telemetry};

/// Number of images sent.
const IMAGES: u32 = 20;
/// Instructions in a second of the microcontroller's time.
const HZ: f64 = 1e9;
/// Number of cycles without an image before the next image: 3.3 cycles begin in the period of an image.
const CYCLES_WITHOUT: u64 = 3;
/// Limit for an image, instructions: 30 images/s on a processor of 480 MHz that executes one instruction in a clock cycle.
const LIMIT: u64 = 480_000_000 / 30;

/// Prints the instructions for each image (reception in packets, the longest cycle, three median cycles) and compares
/// their sum with the limit.
///
/// # Errors
/// If the sum exceeds the limit.
pub(crate) fn check(image: &Path, frame: Frame, played: &Played) -> Result<(), Box<dyn Error>> {
    let reception = reception(image, frame)?;
    let median = played.chain.get(played.chain.len() / 2).copied().unwrap_or(0);
    let longest = played.chain.last().copied().unwrap_or(0);
    let sum = reception + longest + CYCLES_WITHOUT * median;
    println!("{:<30} {reception:>9} instructions", "reception of a camera image");
    println!("{:<30} {sum:>9} of {LIMIT:>9} instructions", "camera image and its cycles");
    if sum > LIMIT { Err("a camera image takes more instructions than 30 images/s allow".into()) } else { Ok(()) }
}

/// Measures the reception of an image by the times of two log entries, between which a few images are received.
fn reception(image: &Path, frame: Frame) -> Result<u64, Box<dyn Error>> {
    let camera = CameraImage::new(frame)?;
    let log = session::log_path(image, "reception", Transport::Pipe);
    let mut robot = session::start_with_log(image, Transport::Pipe, ClockMode::Lockstep, Some(&log))?;
    cause_entry(&mut robot, &camera, 0)?;
    for id in 1..=IMAGES {
        for chunk in chunks(id, &camera.yuyv) {
            robot.link().send(&ToRobot::ImageChunk(chunk))?;
        }
    }
    cause_entry(&mut robot, &camera, 10_000)?;
    drop(robot);
    let lines = crate::log::decode(image, &log)?;
    let entries: Vec<_> = lines.iter().filter(|line| line.contains("an image is incomplete")).collect();
    let [first, last] = entries[..] else {
        return Err(format!("not two incomplete images in the log: {lines:?}").into());
    };
    let [from, to] = [first, last].map(|line| line.split(' ').next().unwrap_or_default().parse::<f64>());
    match (HZ * (to? - from?) / f64::from(IMAGES)) as u64 {
        0 => Err("the reception took no instructions".into()),
        instructions => Ok(instructions),
    }
}

/// Causes a log entry: announces an image that was not sent.
fn cause_entry(robot: &mut Emulator, camera: &CameraImage, time_us: u64) -> Result<(), Box<dyn Error>> {
    robot.link().send(&camera.stands(time_us, 0).message())?;
    Ok(robot.link().receive(telemetry(|_| ()))?)
}
