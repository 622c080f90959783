//! A component that is too slow, while images of a game come in.

use std::error::Error;
use std::path::Path;
use std::thread;

use bica::{ComponentId, Tree};
use bica_emulator::{Carrier, Mouth};
use bica_motion::robot::{CameraId, Command, Lights};
use bica_motion::stand::{STAND, Stiffness};
use bica_player::Forward;
use bica_player::perception::BallDetector;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::message::{Pace, Sensors, Telemetry, Trial};
use bica_wire::{ToRobot, chunks};

use crate::trials::{begin_with, log, same, telemetry};

/// Images that come, 30 in a second; from the first of these on, up to the second, the component is slow.
const IMAGES: u32 = 110;
const SLOW: (u32, u32) = (15, 60);
/// Cycles that are looked at; the images last longer, since the microcontroller's time stands still without any.
const CYCLES: usize = 300;
/// How much longer a run takes then, ticks of 40 ns: 25 ms, two cycles and a half.
const TICKS: u32 = 625_000;
/// What sensors bear that have no time: telemetry after them bears it too, all other the microcontroller's own.
const NO_TIME: u64 = 0;

/// What is sensed with an image, and its pixels.
type Seen = (Sensors, Vec<u8>);

/// What is told of a cycle.
struct Told {
    time_us: u64,
    late: u32,
    torn: u32,
    safe: bool,
    /// Whether the slow component ran, and was slow.
    slow: bool,
}

/// For a second and a half every run of the ball detector takes 25 ms longer.
///
/// # Errors
/// Whatever is not late, not counted, dropped, or not in the log.
pub(crate) fn overload(image: &Path, carrier: Carrier) -> Result<(), Box<dyn Error>> {
    let log = log(image, "overload", carrier);
    let mut robot = begin_with(image, carrier, Pace::Clock, Some(&log))?;
    let frames = frames()?;
    let (ear, mouth) = robot.line().halves();
    let mut told = Vec::new();
    thread::scope(|scope| {
        let writer = scope.spawn(|| stream(mouth, &frames).map_err(|error| error.to_string()));
        while told.len() < CYCLES {
            told.push(ear.hear(telemetry(|telemetry| Told::of(&telemetry)))?);
        }
        writer.join().map_err(|_| "the writer panicked")??;
        Ok::<_, Box<dyn Error>>(())
    })?;
    drop(robot);
    let late = judge(&told)?;
    let lines = crate::log::decode(image, &log)?;
    let logged = lines.iter().filter(|line| line.contains("WARN") && line.contains("late by")).count();
    same(&logged, &(late as usize))?;
    println!("overload: {} cycles, {late} of them late, none dropped; {logged} told by the log", told.len());
    Ok(())
}

/// How many cycles were late.
fn judge(told: &[Told]) -> Result<u32, Box<dyn Error>> {
    let slow: Vec<usize> = (0..told.len()).filter(|&index| told[index].slow).collect();
    let (Some(&first_slow), Some(&last_slow)) = (slow.first(), slow.last()) else {
        return Err("it never was slow".into());
    };
    same(&told[first_slow - 1].late, &0)?;
    let late = told.last().map_or(0, |told| told.late);
    if late < slow.len() as u32 {
        return Err(format!("{} slow runs, but only {late} late cycles", slow.len()).into());
    }
    let calm = told.iter().rev().take_while(|told| told.late == late).count();
    if calm < 50 {
        return Err("it never recovered".into());
    }
    // 30 runs in 100 cycles, as declared, however slow they are.
    let runs = (10 * (slow.len() - 1)) as u32;
    if runs.abs_diff(3 * (last_slow - first_slow) as u32) > 20 {
        return Err(format!("{} runs in {} cycles: some were dropped", slow.len(), last_slow - first_slow).into());
    }
    // A cycle every 10 ms, however late some of them were.
    let own: Vec<(usize, u64)> = told
        .iter()
        .enumerate()
        .filter(|(_, told)| told.time_us != NO_TIME)
        .map(|(at, told)| (at, told.time_us))
        .collect();
    let (Some(first), Some(last)) = (own.first(), own.last()) else { return Err("no cycle has a time".into()) };
    same(&((last.1 - first.1 + 5_000) / 10_000), &((last.0 - first.0) as u64))?;
    let torn = told.last().map_or(0, |told| told.torn);
    same(&(told.iter().any(|told| told.safe), told[first_slow].torn), &(false, 0))?;
    if torn > slow.len() as u32 {
        return Err(format!("{torn} images torn by {} slow runs", slow.len()).into());
    }
    Ok(late)
}

impl Told {
    fn of(telemetry: &Telemetry<'_>) -> Self {
        let ticks = telemetry.cost().nth(ball_detector().index()).unwrap_or(0);
        Self {
            time_us: telemetry.time_us,
            late: telemetry.late,
            torn: telemetry.torn,
            safe: telemetry.safe,
            slow: ticks >= TICKS,
        }
    }
}

fn ball_detector() -> ComponentId {
    Forward::id::<BallDetector>()
}

/// A second of a game as a robot that stands sees it.
fn frames() -> Result<Vec<Seen>, Box<dyn Error>> {
    let mut world = KinematicWorld::new(&Setup { frame: Frame::Small, ..Setup::default() })?;
    let (targets, stiffness) = (STAND, Stiffness::Stand.joints());
    let stand = Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Top };
    let mut frames = Vec::new();
    while frames.len() < 30 {
        let sensors = world.sensors();
        if let Some(image) = &sensors.image {
            frames.push((Sensors::new(NO_TIME, &sensors, 0), image.yuyv.to_vec()));
        }
        world.act(&stand);
    }
    Ok(frames)
}

fn stream(mouth: &mut Mouth<impl std::io::Write>, frames: &[Seen]) -> Result<(), bica_emulator::Error> {
    for (number, (sensors, yuyv)) in (0..IMAGES).zip(frames.iter().cycle()) {
        if number == SLOW.0 || number == SLOW.1 {
            let ticks = if number == SLOW.0 { TICKS } else { 0 };
            mouth.say(&ToRobot::Trial(Trial::Slow { component: ball_detector().index() as u8, ticks }))?;
        }
        for chunk in chunks(number, yuyv) {
            mouth.say(&ToRobot::Chunk(chunk))?;
        }
        let mut sensors = *sensors;
        if let Some(picture) = &mut sensors.picture {
            picture.image = number;
        }
        mouth.say(&ToRobot::Sensors(sensors))?;
    }
    Ok(())
}
