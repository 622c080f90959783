//! A standing body in lockstep with the robot, in a separate thread, and the same cycles on the host.

use std::error::Error;
use std::net::SocketAddr;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bica::runner::Runner;
use bica::{Instant, Tree};
use bica_field::GoalColour;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_player_program::emulator::{Emulator, Transport, command_bits, decode_command};
use bica_wire::FromRobot;
use bica_wire::message::{Change, ClockMode};

use crate::session::{self, standing, stands};

/// Duration of a cycle, µs of the robot's time. The body also waits this long, so that the robot's time is close to real time.
pub(super) const CYCLE_US: u64 = 10_000;

/// A cycle of the robot.
#[derive(Clone)]
pub(super) struct Cycle {
    pub(super) command: Vec<u32>,
    /// One bit for each active component.
    pub(super) active: u64,
}

/// A standing body.
pub(super) struct Body {
    pub(super) monitors: SocketAddr,
    cycles: Arc<Mutex<Vec<Cycle>>>,
    stop: Arc<AtomicBool>,
    thread: JoinHandle<Result<(), String>>,
}

impl Body {
    /// Starts an image and a game.
    pub(super) fn start(image: &Path) -> Result<Self, Box<dyn Error>> {
        let mut robot = Emulator::start_with_monitors(image, Transport::Pipe, None)?;
        let monitors = robot.monitors().ok_or("the emulator has no port for monitors")?;
        robot.link().receive(|message| matches!(message, FromRobot::Identity(_)).then_some(()))?;
        session::start_game(&mut robot, ClockMode::Lockstep)?;
        let (cycles, stop) = (Arc::new(Mutex::new(Vec::new())), Arc::new(AtomicBool::new(false)));
        let (list, stopped) = (Arc::clone(&cycles), Arc::clone(&stop));
        let thread = thread::spawn(move || run(&mut robot, &list, &stopped).map_err(|error| error.to_string()));
        Ok(Self { monitors, cycles, stop, thread })
    }

    /// Number of cycles so far.
    pub(super) fn count(&self) -> usize {
        self.cycles.lock().unwrap_or_else(PoisonError::into_inner).len()
    }

    /// Waits until the robot has run `count` cycles.
    pub(super) fn wait_for(&self, count: usize) -> Result<(), Box<dyn Error>> {
        while self.count() < count {
            if self.thread.is_finished() {
                return Err("the body ended".into());
            }
            thread::sleep(Duration::from_millis(5));
        }
        Ok(())
    }

    /// Ends the game and returns its cycles.
    pub(super) fn stop(self) -> Result<Vec<Cycle>, Box<dyn Error>> {
        self.stop.store(true, Ordering::Relaxed);
        self.thread.join().map_err(|_| "the body panicked")??;
        let cycles = self.cycles.lock().unwrap_or_else(PoisonError::into_inner).clone();
        Ok(cycles)
    }
}

fn run(robot: &mut Emulator, cycles: &Mutex<Vec<Cycle>>, stop: &AtomicBool) -> Result<(), Box<dyn Error>> {
    let mut time_us = 0;
    while !stop.load(Ordering::Relaxed) {
        robot.link().send(&stands(time_us).message())?;
        let mut command = Vec::new();
        let active = robot.link().receive(|message| match message {
            FromRobot::Command(sent) if sent.time_us == time_us => {
                command = decode_command(&sent).map(|command| command_bits(&command).collect()).unwrap_or_default();
                None
            }
            FromRobot::Telemetry(telemetry) if telemetry.time_us == time_us => Some(telemetry.active),
            _ => None,
        })?;
        cycles.lock().unwrap_or_else(PoisonError::into_inner).push(Cycle { command, active });
        time_us += CYCLE_US;
        thread::sleep(Duration::from_micros(CYCLE_US));
    }
    Ok(())
}

/// Requires that the same cycles on the host, with the same changes before the cycles of these numbers, give the same commands.
pub(super) fn compare_with_host(cycles: &[Cycle], changes: &[(u64, Change)]) -> Result<(), Box<dyn Error>> {
    match first_difference(cycles, changes)? {
        None => Ok(()),
        Some(cycle) => Err(format!("cycle {cycle} of {} differs from the host's", cycles.len()).into()),
    }
}

/// Returns the first cycle that differs from the host's.
pub(super) fn first_difference(cycles: &[Cycle], changes: &[(u64, Change)]) -> Result<Option<usize>, Box<dyn Error>> {
    let mut runner = Runner::new(Box::new(Forward::new()), ());
    runner.robot_mut().get_mut::<GoalDetector>().attack(GoalColour::Yellow);
    for (index, cycle) in cycles.iter().enumerate() {
        let time_us = index as u64 * CYCLE_US;
        let now = Instant::from_micros(time_us);
        for (_, change) in changes.iter().filter(|(cycle, _)| *cycle == index as u64) {
            runner.request(now, change.borrow())?;
        }
        runner.sense(now, &standing()).map_err(|_| "an image does not fit")?;
        let command = runner.think(now);
        let active = runner.robot().active().fold(0, |set, id| set | 1 << id.index());
        if !command_bits(&command).eq(cycle.command.iter().copied()) || active != cycle.active {
            return Ok(Some(index));
        }
    }
    Ok(None)
}
