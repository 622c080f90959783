//! A game with an emulated robot, driven message by message.

use std::error::Error;
use std::path::{Path, PathBuf};

use bica_emulator::{Emulator, Transport};
use bica_field::GoalColour;
use bica_motion::joints::JOINTS;
use bica_motion::model::{Nao, RobotModel};
use bica_sim::setup::Frame;
use bica_wire::message::{ClockMode, Command, Hello, Sensors, Telemetry};
use bica_wire::{FromRobot, SCHEMA, ToRobot};

use crate::limits;

/// Starts an image and a game.
pub(crate) fn start(image: &Path, transport: Transport, clock_mode: ClockMode) -> Result<Emulator, Box<dyn Error>> {
    start_with_log(image, transport, clock_mode, None)
}

/// Starts an image and a game. The log is written to a file, if one is given.
pub(crate) fn start_with_log(
    image: &Path,
    transport: Transport,
    clock_mode: ClockMode,
    log: Option<&Path>,
) -> Result<Emulator, Box<dyn Error>> {
    let mut robot = Emulator::start(image, transport, log)?;
    robot.link().receive(identity())?;
    start_game(&mut robot, clock_mode)?;
    Ok(robot)
}

/// Starts a game on a running image.
pub(crate) fn start_game(robot: &mut Emulator, clock_mode: ClockMode) -> Result<(), Box<dyn Error>> {
    robot.link().send(&hello(clock_mode))?;
    robot.link().receive(identity()).map_err(Into::into)
}

/// Returns the size of the largest camera images that an image takes.
pub(crate) fn frame(image: &Path) -> Result<Frame, Box<dyn Error>> {
    let mut robot = Emulator::start(image, Transport::Pipe, None)?;
    let bytes = robot.link().receive(|message| match message {
        FromRobot::Identity(identity) => Some(identity.image_bytes as usize),
        _ => None,
    })?;
    let found = [Frame::Small, Frame::Medium].into_iter().find(|frame| limits::bytes(*frame) == bytes);
    found.ok_or_else(|| format!("the image takes camera images of {bytes} bytes, a size without limits").into())
}

/// Returns the path of the log file of a scenario.
pub(crate) fn log_path(image: &Path, scenario: &str, transport: Transport) -> PathBuf {
    image.with_extension(format!("{scenario}.{transport:?}.log"))
}

/// Returns the message that starts a game.
pub(crate) const fn hello(clock_mode: ClockMode) -> ToRobot<'static> {
    ToRobot::Hello(Hello { schema: SCHEMA, clock_mode, attacks: GoalColour::Yellow })
}

/// Selects the robot's identity.
fn identity() -> impl FnMut(FromRobot<'_>) -> Option<()> {
    |message| matches!(message, FromRobot::Identity(_)).then_some(())
}

/// Selects a command.
pub(crate) fn command() -> impl FnMut(FromRobot<'_>) -> Option<Command> {
    |message| if let FromRobot::Command(command) = message { Some(command) } else { None }
}

/// Selects a value from the report of a cycle.
pub(crate) fn telemetry<T>(read: impl Fn(Telemetry<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| if let FromRobot::Telemetry(telemetry) = message { Some(read(telemetry)) } else { None }
}

/// Returns the sensor values of a robot that stands still.
pub(crate) fn standing(time_us: u64) -> Sensors {
    let (inertial, feet) = ([0.0, 0.0, 0.0, 0.0, 0.0, 9.81, 0.0, 0.0], [6.5; 8]);
    let (temperatures, currents) = ([30.0; JOINTS], [0.2; JOINTS]);
    Sensors { time_us, angles: Nao::STAND.0, temperatures, currents, inertial, feet, buttons: [false; 3], image: None }
}

/// Requires that a value equals the expected one.
///
/// # Errors
/// Both values, if they differ.
pub(crate) fn expect_eq<T: PartialEq + std::fmt::Debug>(found: &T, expected: &T) -> Result<(), Box<dyn Error>> {
    if found == expected { Ok(()) } else { Err(format!("found {found:?}, expected {expected:?}").into()) }
}
