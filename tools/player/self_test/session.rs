//! A game with an emulated robot, driven message by message.

use std::error::Error;
use std::path::{Path, PathBuf};

use bica_motion::joints::Joints;
use bica_motion::model::NAO;
use bica_motion::robot::{Buttons, Command, FootPressure, Inertial, Sensors};
use bica_player_program::emulator::{Emulator, MESSAGES, SensorsMessage, Transport, decode_command};
use bica_sim::setup::Frame;
use bica_wire::message::{ClockMode, Hello, Telemetry};
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

/// Returns the size of the largest camera images that a firmware image accepts.
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
    // The attacked goal is the yellow one.
    ToRobot::Hello(Hello { schema: SCHEMA, messages: MESSAGES, clock_mode, set_up: &[0] })
}

/// Selects the robot's identity.
fn identity() -> impl FnMut(FromRobot<'_>) -> Option<()> {
    |message| matches!(message, FromRobot::Identity(_)).then_some(())
}

/// Selects a command.
pub(crate) fn command() -> impl FnMut(FromRobot<'_>) -> Option<Command> {
    |message| if let FromRobot::Command(command) = message { decode_command(&command).ok() } else { None }
}

/// Selects a value from the report of a cycle.
pub(crate) fn telemetry<T>(read: impl Fn(Telemetry<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| if let FromRobot::Telemetry(telemetry) = message { Some(read(telemetry)) } else { None }
}

/// Returns the sensor values of a robot that stands still.
pub(crate) fn standing() -> Sensors<'static> {
    let foot = FootPressure { front_left: 6.5, front_right: 6.5, rear_left: 6.5, rear_right: 6.5 };
    Sensors {
        angles: NAO.stand,
        temperatures: Joints::all(30.0),
        currents: Joints::all(0.2),
        inertial: Inertial { acceleration: [0.0, 0.0, 9.81].into(), ..Inertial::default() },
        left_foot: foot,
        right_foot: foot,
        buttons: Buttons::default(),
        image: None,
    }
}

/// Returns the sensor message of a robot that stands still.
pub(crate) fn stands(time_us: u64) -> SensorsMessage {
    SensorsMessage::new(time_us, &standing(), 0)
}

/// Requires that a value equals the expected one.
///
/// # Errors
/// Both values, if they differ.
pub(crate) fn expect_eq<T: PartialEq + std::fmt::Debug>(found: &T, expected: &T) -> Result<(), Box<dyn Error>> {
    if found == expected { Ok(()) } else { Err(format!("found {found:?}, expected {expected:?}").into()) }
}
