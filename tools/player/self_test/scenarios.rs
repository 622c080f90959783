//! Reactions of the robot to requests, damage, faults and silence.

use std::error::Error;
use std::path::Path;

use bica::Tree;
use bica_motion::joints::Joints;
use bica_motion::model::NAO;
use bica_motion::robot::{CameraId, Command, Image, Sensors};
use bica_motion::stiffness::Stiffness;
use bica_player::Forward;
use bica_player::motion::Head;
use bica_player_program::emulator::{SensorsMessage, Transport};
use bica_wire::message::{ClockMode, FaultInjection, GraphItem, ImageChunk, LinkStats};
use bica_wire::{FromRobot, ToRobot};

use crate::overload;
use crate::session::{self, command, expect_eq, log_path, standing, stands, telemetry};

type Outcome = Result<(), Box<dyn Error>>;
/// A scenario: the property that it checks, the transport, and the check.
type Scenario = (&'static str, Transport, fn(&Path, Transport) -> Outcome);

/// All scenarios.
pub(crate) const ALL: [Scenario; 9] = [
    ("the robot sends the graph of its tree", Transport::Pipe, describe),
    ("the robot sends the graph of its tree, serial port", Transport::Serial, describe),
    ("damaged, truncated and lost packets are counted and tolerated", Transport::Pipe, damage),
    ("damaged, truncated and lost packets are counted and tolerated, serial port", Transport::Serial, damage),
    ("no byte is lost when more come than the queue holds, serial port", Transport::Serial, flood),
    ("a panic switches all joints off; its message survives the restart", Transport::Pipe, panic),
    ("a panic switches all joints off; its message survives the restart, serial port", Transport::Serial, panic),
    ("silence of the body causes a safe stop although a monitor sends, serial port", Transport::Serial, silence),
    ("a slow component delays cycles and drops none, while images arrive", Transport::PacedPipe, overload::overload),
];

fn describe(image: &Path, transport: Transport) -> Outcome {
    let mut robot = session::start(image, transport, ClockMode::Lockstep)?;
    let link = robot.link();
    link.send(&ToRobot::Describe)?;
    let (mut names, mut parts, mut received) = (Vec::new(), 0, 0);
    let items = link.receive(|message| {
        let FromRobot::GraphItem(item) = message else { return None };
        match item {
            GraphItem::End { items } => return Some(items),
            GraphItem::Component { name, .. } => names.push(name.to_owned()),
            GraphItem::Link { .. } | GraphItem::State { .. } | GraphItem::Transition { .. } => parts += 1,
            _ => {}
        }
        received += 1;
        None
    })?;
    let nodes = Forward::GRAPH.nodes;
    expect_eq(&names, &nodes.iter().map(|node| node.name.to_owned()).collect())?;
    let expected = nodes.iter().map(|node| node.links.len() + node.states.len() + node.transitions.len());
    expect_eq(&parts, &expected.sum())?;
    expect_eq(&received, &items)
}

fn damage(image: &Path, transport: Transport) -> Outcome {
    let mut robot = session::start(image, transport, ClockMode::Lockstep)?;
    let link = robot.link();
    link.send(&ToRobot::ImageChunk(ImageChunk { image_id: 1, offset: 0, bytes: &[128; 1000] }))?;
    link.write(&[7, 1, 2, 3, 4, 5, 6, 0, 200, 9, 9, 0])?;
    let pixels = vec![128; 2 * 160 * 120];
    let image = Image { camera: CameraId::Top, width: 160, height: 120, yuyv: &pixels };
    let sensors = SensorsMessage::new(0, &Sensors { image: Some(image), ..standing() }, 1);
    link.send(&sensors.message())?;
    let (incomplete, stats) = link.receive(telemetry(|telemetry| (telemetry.incomplete_images, telemetry.link)))?;
    expect_eq(&(incomplete, stats.damaged, stats.missing), &(1, 2, 0))?;
    for _ in 0..3 {
        link.skip();
    }
    link.send(&stands(10_000).message())?;
    link.receive(telemetry(|_| ()))?;
    link.send(&stands(20_000).message())?;
    let stats: LinkStats = link.receive(telemetry(|telemetry| telemetry.link))?;
    expect_eq(&(stats.damaged, stats.missing), &(2, 3))
}

/// Number of requests that are sent at once: several times the capacity of the port's queue.
const FLOOD: usize = 2000;

fn flood(image: &Path, transport: Transport) -> Outcome {
    let mut robot = session::start(image, transport, ClockMode::Lockstep)?;
    let (rx, tx) = robot.link().halves();
    let mut bytes = Vec::new();
    for _ in 0..FLOOD {
        bytes.extend(tx.encode(&ToRobot::StackUsage)?);
    }
    tx.write(&bytes)?;
    for _ in 0..FLOOD {
        rx.receive(|message| matches!(message, FromRobot::StackUsage(_)).then_some(()))?;
    }
    tx.send(&stands(0).message())?;
    let stats: LinkStats = rx.receive(telemetry(|telemetry| telemetry.link))?;
    expect_eq(&(stats.damaged, stats.missing), &(0, 0))
}

fn panic(image: &Path, transport: Transport) -> Outcome {
    let log = log_path(image, "panic", transport);
    let mut robot = session::start_with_log(image, transport, ClockMode::Lockstep, Some(&log))?;
    let link = robot.link();
    link.send(&ToRobot::FaultInjection(FaultInjection::Panic { component: head() }))?;
    link.send(&stands(0).message())?;
    let last: Command = link.receive(command())?;
    expect_eq(&last.stiffness, &Joints::all(0.0))?;
    let (restarts, last_panic) = link.receive(|message| match message {
        FromRobot::Identity(identity) => Some((identity.restarts, identity.last_panic.to_owned())),
        _ => None,
    })?;
    expect_eq(&(restarts, last_panic.contains("injected: Head panics")), &(1, true))?;
    session::start_game(&mut robot, ClockMode::Lockstep)?;
    robot.link().send(&stands(0).message())?;
    robot.link().receive(command())?;
    drop(robot);
    let lines = crate::log::decode(image, &log)?;
    let logged = |text: &str| lines.iter().any(|line| line.contains("ERROR") && line.contains(text));
    expect_eq(&(logged("restart 1 after a panic"), logged("injected: Head panics")), &(true, true))
}

/// Allowed time from the first cycle of the game to the safe stop, µs: 200 ms of silence, within two cycles.
const SILENCE_US: std::ops::RangeInclusive<u64> = 180_000..=220_000;

fn silence(image: &Path, transport: Transport) -> Outcome {
    let mut robot = session::start(image, transport, ClockMode::FreeRunning)?;
    let link = robot.link();
    let read = || telemetry(|telemetry| (telemetry.time_us, telemetry.safe_stop));
    let (start_us, safe_stop) = link.receive(read())?;
    expect_eq(&safe_stop, &false)?;
    let stop_us = loop {
        let (time_us, safe_stop) = link.receive(read())?;
        if safe_stop {
            break time_us;
        }
        link.send(&ToRobot::Monitor(&[0]))?;
    };
    if !SILENCE_US.contains(&(stop_us - start_us)) {
        return Err(format!("safe stop {} µs after the first cycle", stop_us - start_us).into());
    }
    let stop = link.receive(command())?;
    expect_eq(&(stop.targets, stop.stiffness), &(NAO.stand, Stiffness::Stand.joints(NAO)))?;
    link.send(&ToRobot::Monitor(&[0]))?;
    expect_eq(&link.receive(telemetry(|telemetry| telemetry.safe_stop))?, &true)?;
    link.send(&stands(0).message())?;
    while link.receive(telemetry(|telemetry| telemetry.safe_stop))? {}
    Ok(())
}

/// Index of a component that runs in every cycle.
fn head() -> u8 {
    Forward::id::<Head>().index() as u8
}
