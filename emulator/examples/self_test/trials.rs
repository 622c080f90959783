//! What the robot does when things go wrong.

use std::error::Error;
use std::path::Path;

use bica::Tree;
use bica_emulator::{Carrier, Emulator};
use bica_motion::joints::JOINTS;
use bica_motion::stand::{STAND, Stiffness};
use bica_player::Forward;
use bica_player::motion::Head;
use bica_wire::message::{Attack, Chunk, Command, Fact, Hello, Pace, Picture, Sensors, Telemetry, Trial};
use bica_wire::{FromRobot, Losses, SCHEMA, ToRobot};

type Done = Result<(), Box<dyn Error>>;
type Try = (&'static str, fn(&Path) -> Done);

/// Every trial.
pub(crate) fn run(image: &Path) -> Done {
    let trials: [Try; 5] = [
        ("it describes itself", describes),
        ("damaged, cut and lost packets are counted and survived", damage),
        ("a panic leaves the joints limp, and its reason lives on", panic),
        ("silence makes it stand safe, a word wakes it", silence),
        ("a slow component makes cycles late and drops none", overload),
    ];
    for (name, trial) in trials {
        trial(image).map_err(|error| format!("not so: {name}: {error}"))?;
        println!("trial: {name}");
    }
    Ok(())
}

fn describes(image: &Path) -> Done {
    let mut robot = begin(image, Carrier::Pipe, Pace::Lockstep)?;
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

fn damage(image: &Path) -> Done {
    let mut robot = begin(image, Carrier::Pipe, Pace::Lockstep)?;
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

fn panic(image: &Path) -> Done {
    let mut robot = begin(image, Carrier::Pipe, Pace::Lockstep)?;
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
    hello(&mut robot, Pace::Lockstep)?;
    robot.line().say(&ToRobot::Sensors(sensors(0)))?;
    robot.line().hear(command()).map(drop).map_err(Into::into)
}

fn silence(image: &Path) -> Done {
    let mut robot = begin(image, Carrier::Serial, Pace::Clock)?;
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

/// For a second every run of a component takes one and a half cycles.
fn overload(image: &Path) -> Done {
    let mut robot = begin(image, Carrier::Serial, Pace::Clock)?;
    let line = robot.line();
    let (first, late) = line.hear(telemetry(|telemetry| (telemetry.time_us, telemetry.late)))?;
    same(&late, &0)?;
    line.say(&ToRobot::Trial(Trial::Slow { component: head(), ticks: 375_000 }))?;
    let mut cycles = 0_u64;
    let mut next = |line: &mut bica_emulator::Line<_, _>| {
        cycles += 1;
        line.hear(telemetry(|telemetry| (telemetry.time_us, telemetry.late)))
    };
    while next(line)?.1 < 50 {}
    line.say(&ToRobot::Trial(Trial::Slow { component: head(), ticks: 0 }))?;
    let (mut before, mut calm) = (0, 0);
    let mut last = 0;
    while calm < 20 {
        let (time, late) = next(line)?;
        calm = if late == before { calm + 1 } else { 0 };
        (before, last) = (late, time);
    }
    // A cycle every 10 ms, however late some of them were.
    same(&((last - first + 5_000) / 10_000), &cycles)
}

fn begin(image: &Path, carrier: Carrier, pace: Pace) -> Result<Emulator, Box<dyn Error>> {
    let log = image.with_extension("trial.log");
    let mut robot = Emulator::start(image, carrier, Some(&log))?;
    robot.line().hear(greeting())?;
    hello(&mut robot, pace)?;
    Ok(robot)
}

fn hello(robot: &mut Emulator, pace: Pace) -> Done {
    robot.line().say(&ToRobot::Hello(Hello { schema: SCHEMA, pace, attack: Attack::Yellow }))?;
    robot.line().hear(greeting()).map_err(Into::into)
}

fn greeting() -> impl FnMut(FromRobot<'_>) -> Option<()> {
    |message| matches!(message, FromRobot::Greeting(_)).then_some(())
}

fn command() -> impl FnMut(FromRobot<'_>) -> Option<Command> {
    |message| if let FromRobot::Command(command) = message { Some(command) } else { None }
}

fn telemetry<T>(read: impl Fn(Telemetry<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| if let FromRobot::Telemetry(telemetry) = message { Some(read(telemetry)) } else { None }
}

/// A robot that stands still.
fn sensors(time_us: u64) -> Sensors {
    let (inertial, feet) = ([0.0, 0.0, 0.0, 0.0, 0.0, 9.81, 0.0, 0.0], [6.5; 8]);
    Sensors { time_us, angles: STAND.0, inertial, feet, buttons: [false; 3], picture: None }
}

/// A component that runs in every cycle.
fn head() -> u8 {
    Forward::id::<Head>().index() as u8
}

fn same<T: PartialEq + std::fmt::Debug>(found: &T, wanted: &T) -> Done {
    if found == wanted { Ok(()) } else { Err(format!("found {found:?}, wanted {wanted:?}").into()) }
}
