//! What the robot does when things go wrong.

use std::error::Error;
use std::path::{Path, PathBuf};

use bica::Tree;
use bica_emulator::{Carrier, Emulator};
use bica_field::GoalColour;
use bica_motion::joints::JOINTS;
use bica_motion::stand::{STAND, Stiffness};
use bica_player::Forward;
use bica_player::motion::Head;
use bica_wire::message::{Chunk, Command, Fact, Hello, Pace, Picture, Sensors, Telemetry, Trial};
use bica_wire::{FromRobot, Losses, SCHEMA, ToRobot};

use crate::overload;

type Done = Result<(), Box<dyn Error>>;
type Try = (&'static str, Carrier, fn(&Path, Carrier) -> Done);

/// Every trial.
pub(crate) const ALL: [Try; 8] = [
    ("it describes itself", Carrier::Pipe, describes),
    ("it describes itself over the serial port", Carrier::Serial, describes),
    ("damaged, cut and lost packets are counted and survived", Carrier::Pipe, damage),
    ("damaged, cut and lost packets are counted and survived over the serial port", Carrier::Serial, damage),
    ("a panic leaves the joints limp, and its reason lives on", Carrier::Pipe, panic),
    ("a panic leaves the joints limp, and its reason lives on, over the serial port", Carrier::Serial, panic),
    ("silence makes it stand safe, a word over the serial port wakes it", Carrier::Serial, silence),
    ("a slow component makes cycles late and drops none, while images come", Carrier::Line, overload::overload),
];

fn describes(image: &Path, carrier: Carrier) -> Done {
    let mut robot = begin(image, carrier, Pace::Lockstep)?;
    let line = robot.line();
    line.say(&ToRobot::Describe)?;
    let mut names = Vec::new();
    let facts = line.hear(|message| match message {
        FromRobot::Fact(Fact::End { facts }) => Some(facts),
        FromRobot::Fact(Fact::Component { name, .. }) => {
            names.push(name.to_owned());
            None
        }
        _ => None,
    })?;
    same(&names, &Forward::GRAPH.nodes.iter().map(|node| node.name.to_owned()).collect())?;
    same(&usize::from(facts), &(bica_wire::describe(&Forward::GRAPH).count() - 1))
}

fn damage(image: &Path, carrier: Carrier) -> Done {
    let mut robot = begin(image, carrier, Pace::Lockstep)?;
    let line = robot.line();
    line.say(&ToRobot::Chunk(Chunk { image: 1, at: 0, bytes: &[128; 1000] }))?;
    line.write(&[7, 1, 2, 3, 4, 5, 6, 0, 200, 9, 9, 0])?;
    let picture = Some(Picture { image: 1, bottom: false, width: 160, height: 120 });
    line.say(&ToRobot::Sensors(Sensors { picture, ..sensors(0) }))?;
    let (torn, losses) = line.hear(telemetry(|telemetry| (telemetry.torn, telemetry.losses)))?;
    same(&(torn, losses.damaged, losses.missing), &(1, 2, 0))?;
    for _ in 0..3 {
        line.lose();
    }
    line.say(&ToRobot::Sensors(sensors(10_000)))?;
    line.hear(telemetry(|_| ()))?;
    line.say(&ToRobot::Sensors(sensors(20_000)))?;
    let losses: Losses = line.hear(telemetry(|telemetry| telemetry.losses))?;
    same(&(losses.damaged, losses.missing), &(2, 3))
}

fn panic(image: &Path, carrier: Carrier) -> Done {
    let log = log(image, "panic", carrier);
    let mut robot = begin_with(image, carrier, Pace::Lockstep, Some(&log))?;
    let line = robot.line();
    line.say(&ToRobot::Trial(Trial::Panic { component: head() }))?;
    line.say(&ToRobot::Sensors(sensors(0)))?;
    let last: Command = line.hear(command())?;
    same(&last.stiffness, &[0.0; JOINTS])?;
    let (restarts, reason) = line.hear(|message| match message {
        FromRobot::Greeting(greeting) => Some((greeting.restarts, greeting.reason.to_owned())),
        _ => None,
    })?;
    same(&(restarts, reason.contains("a trial: Head panics")), &(1, true))?;
    greet(&mut robot, Pace::Lockstep)?;
    robot.line().say(&ToRobot::Sensors(sensors(0)))?;
    robot.line().hear(command())?;
    drop(robot);
    let lines = crate::log::decode(image, &log)?;
    let told = |words: &str| lines.iter().any(|line| line.contains("ERROR") && line.contains(words));
    same(&(told("started anew, 1 times by now"), told("a trial: Head panics")), &(true, true))
}

fn silence(image: &Path, carrier: Carrier) -> Done {
    let mut robot = begin(image, carrier, Pace::Clock)?;
    let line = robot.line();
    let safe = line.hear(telemetry(|telemetry| telemetry.safe))?;
    same(&safe, &false)?;
    while !line.hear(telemetry(|telemetry| telemetry.safe))? {}
    let stands = line.hear(command())?;
    same(&(stands.targets, stands.stiffness), &(STAND.0, Stiffness::Stand.joints().0))?;
    line.say(&ToRobot::Sensors(sensors(0)))?;
    while line.hear(telemetry(|telemetry| telemetry.safe))? {}
    Ok(())
}

/// Starts an image and a game.
pub(crate) fn begin(image: &Path, carrier: Carrier, pace: Pace) -> Result<Emulator, Box<dyn Error>> {
    begin_with(image, carrier, pace, None)
}

/// The same with a log.
pub(crate) fn begin_with(
    image: &Path,
    carrier: Carrier,
    pace: Pace,
    log: Option<&Path>,
) -> Result<Emulator, Box<dyn Error>> {
    let mut robot = Emulator::start(image, carrier, log)?;
    robot.line().hear(greeting())?;
    greet(&mut robot, pace)?;
    Ok(robot)
}

/// Where a trial's log goes.
pub(crate) fn log(image: &Path, trial: &str, carrier: Carrier) -> PathBuf {
    image.with_extension(format!("{trial}.{carrier:?}.log"))
}

/// What begins a game.
pub(crate) const fn hello(pace: Pace) -> ToRobot<'static> {
    ToRobot::Hello(Hello { schema: SCHEMA, pace, attack: GoalColour::Yellow })
}

fn greet(robot: &mut Emulator, pace: Pace) -> Done {
    robot.line().say(&hello(pace))?;
    robot.line().hear(greeting()).map_err(Into::into)
}

fn greeting() -> impl FnMut(FromRobot<'_>) -> Option<()> {
    |message| matches!(message, FromRobot::Greeting(_)).then_some(())
}

fn command() -> impl FnMut(FromRobot<'_>) -> Option<Command> {
    |message| if let FromRobot::Command(command) = message { Some(command) } else { None }
}

/// What is told of a cycle.
pub(crate) fn telemetry<T>(read: impl Fn(Telemetry<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| if let FromRobot::Telemetry(telemetry) = message { Some(read(telemetry)) } else { None }
}

/// A robot that stands still.
pub(crate) fn sensors(time_us: u64) -> Sensors {
    let (inertial, feet) = ([0.0, 0.0, 0.0, 0.0, 0.0, 9.81, 0.0, 0.0], [6.5; 8]);
    let (temperatures, currents) = ([30.0; JOINTS], [0.2; JOINTS]);
    Sensors { time_us, angles: STAND.0, temperatures, currents, inertial, feet, buttons: [false; 3], picture: None }
}

/// A component that runs in every cycle.
fn head() -> u8 {
    Forward::id::<Head>().index() as u8
}

/// Holds that something is as it has to be.
pub(crate) fn same<T: PartialEq + std::fmt::Debug>(found: &T, wanted: &T) -> Done {
    if found == wanted { Ok(()) } else { Err(format!("found {found:?}, wanted {wanted:?}").into()) }
}
