//! Worlds for games.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use bica_app::{Failure, WorldOptions};
use bica_motion::joints::Joint;
use bica_motion::pose::Pose2;
use bica_sim::SpectatorView;
use bica_sim::faults::{Faults, FaultyWorld, ImageFault};
use bica_sim::kinematic;
use bica_sim::setup::{Setup, SetupError, Start};
use glam::{Vec2, Vec3};

use crate::game::rules::{Rules, WorldKind};

/// Options of the worlds, for `--help`.
pub(crate) const OPTIONS: &str = "\
Option of the world; may be repeated: robot=X,Y,HEADING (start, m and rad), ball=X,Y or ball=X,Y,VX,VY (start and velocity, m and m/s), \
image=freeze|dark|bright|noise|drop, gyro=RATE (offset, rad/s), stuck=JOINT, hot=JOINT, \
mounting=ROLL,TILT,PAN (error of both cameras in the head, rad; not in MuJoCo), from=S and until=S (time of these faults), \
button=S or button=S,S (presses of the chest button)";

/// Creates a world at the start of a game.
pub(crate) fn open(rules: &Rules) -> Result<Box<dyn SpectatorView>, Failure> {
    let options = WorldOptions::new(rules.seed, rules.options)?;
    let setup = Setup { seed: rules.seed, frame: rules.size, robots: rules.robots, ..Setup::default() };
    // Places on the carpet are checked with the world.
    let robot = numbers(&options, "robot", [3], -10.0..=10.0)?;
    let ball = numbers(&options, "ball", [2, 4], -10.0..=10.0)?;
    let mounting = numbers(&options, "mounting", [3], -0.5..=0.5)?;
    let faults = faults(&options)?;
    options.check_all_read(rules.world.name())?;
    let failed = |error: SetupError| {
        let help = "try another number of --robots, or another --option of the start";
        Failure::new(format!("the game cannot be set up: {error}"), help)
    };
    let drawn = kinematic::nao(&setup, Vec2::ZERO).map_err(failed)?;
    let place = |at: &[f32]| Vec2::new(at[0], at[1]);
    let start = (!robot.is_empty() || !ball.is_empty()).then(|| Start {
        robot: robot.first().map_or(drawn.referee().robot(), |_| Pose2::new(robot[0], robot[1], robot[2])),
        ball: ball.first().map_or(drawn.referee().ball(), |_| place(&ball)),
    });
    let mounting = mounting.first().map_or(Vec3::ZERO, |_| Vec3::new(mounting[0], mounting[1], mounting[2]));
    if mounting != Vec3::ZERO && rules.world != WorldKind::BuiltIn {
        let what = "--option mounting: the cameras of this world are mounted as in the data sheet";
        return Err(Failure::new(what, "leave it out, or play in the built-in world"));
    }
    let setup = Setup { start, mounting, ..setup };
    let velocity = if ball.len() == 4 { place(&ball[2..]) } else { Vec2::ZERO };
    let world: Box<dyn SpectatorView> = match rules.world {
        WorldKind::BuiltIn => kinematic::nao(&setup, velocity).map_err(failed)?,
        #[cfg(feature = "mujoco")]
        WorldKind::Mujoco => mujoco(&setup, velocity)?,
    };
    if faults == Faults::default() {
        return Ok(world);
    }
    Ok(Box::new(FaultyWorld::new(world, faults, rules.size, rules.seed)))
}

#[cfg(feature = "mujoco")]
fn mujoco(setup: &Setup, ball: Vec2) -> Result<Box<dyn SpectatorView>, Failure> {
    use bica_sim::mujoco::{self, Error};
    mujoco::nao(setup, ball).map_err(|error| match &error {
        Error::Camera(what) => {
            Failure::new(format!("MuJoCo cannot draw: {what}"), "`cargo xtask mujoco` installs what that needs")
        }
        _ => Failure::new(
            format!("the game cannot be set up: {error}"),
            "try another number of --robots, or another --option",
        ),
    })
}

/// Parses the options of the faults.
fn faults(options: &WorldOptions) -> Result<Faults, Failure> {
    let none = Faults::default();
    let joint = |name| {
        let text = options.value(name, String::new())?;
        let joint = Joint::ALL.into_iter().find(|joint| format!("{joint:?}") == text);
        if joint.is_none() && !text.is_empty() {
            let names = Joint::ALL.map(|joint| format!("{joint:?}")).join(", ");
            return Err(Failure::new(
                format!("--option {name}={text}: no joint has this name"),
                format!("give one of {names}"),
            ));
        }
        Ok(joint)
    };
    let number = |name: &str, default: f32, within| {
        numbers(options, name, [1], within).map(|given| given.first().copied().unwrap_or(default))
    };
    let image = options.value("image", String::new())?;
    let image = (!image.is_empty()).then(|| image.parse::<ImageFault>());
    let wrong = |error| Failure::new(format!("--option image: {error}"), "choose one of them");
    let presses = numbers(options, "button", [1, 2], TIMES)?;
    let (from, until) = (number("from", none.from, TIMES)?, number("until", none.until, TIMES)?);
    let faults = Faults {
        image: image.transpose().map_err(wrong)?,
        gyro: number("gyro", none.gyro, -MAX_GYRO..=MAX_GYRO)?,
        stuck: joint("stuck")?,
        hot: joint("hot")?,
        presses: [0, 1].map(|press| presses.get(press).copied().unwrap_or(f32::INFINITY)),
        ..none
    };
    let is_timed = (Faults { from, until, ..none }) != none;
    if is_timed && (from >= until || faults == Faults { presses: faults.presses, ..none }) {
        let what = "--option from and until: there is no fault in this time";
        return Err(Failure::new(what, "give a fault, such as image=freeze, and a time `from` before `until`"));
    }
    Ok(Faults { from, until, ..faults })
}

/// Times of a game, s: as long as `--seconds` may be.
const TIMES: RangeInclusive<f32> = 0.0..=86_400.0;
/// Full scale of usual gyroscopes, 2000°/s, in rad/s.
const MAX_GYRO: f32 = 35.0;

/// The numbers of an option: none, or as many as one of `counts`, in a range.
fn numbers<const N: usize>(
    options: &WorldOptions,
    name: &str,
    counts: [usize; N],
    within: RangeInclusive<f32>,
) -> Result<Vec<f32>, Failure> {
    let Numbers(given) = options.value(name, Numbers::default())?;
    if let Some(odd) = given.iter().find(|number| !within.contains(*number)) {
        let what = format!("--option {name}: {odd:?} is out of range");
        return Err(Failure::new(what, format!("give numbers from {} to {}", within.start(), within.end())));
    }
    if given.is_empty() || counts.contains(&given.len()) {
        return Ok(given);
    }
    let counts = counts.map(|count| count.to_string()).join(" or ");
    let what = format!("--option {name} has {} numbers", given.len());
    Err(Failure::new(what, format!("give {counts}, with commas between them")))
}

/// Finite numbers, separated by commas.
#[derive(Clone, Debug, Default)]
struct Numbers(Vec<f32>);

/// Error: a text is not [`Numbers`].
struct NoNumbers;

impl fmt::Display for NoNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("give finite numbers with commas between them")
    }
}

impl FromStr for Numbers {
    type Err = NoNumbers;

    fn from_str(text: &str) -> Result<Self, NoNumbers> {
        let number = |part: &str| part.trim().parse().ok().filter(|number: &f32| number.is_finite());
        text.split(',').map(number).collect::<Option<_>>().map(Self).ok_or(NoNumbers)
    }
}
