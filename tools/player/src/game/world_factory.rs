//! Worlds for games.

use std::fmt;
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
    let robot = options.value("robot", Numbers::default())?.exactly([3], "robot")?;
    let ball = options.value("ball", Numbers::default())?.exactly([2, 4], "ball")?;
    let mounting = options.value("mounting", Numbers::default())?.exactly([3], "mounting")?;
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
    let number =
        |name: &str, default: f32| options.value(name, Numbers(vec![default]))?.exactly([1], name).map(|n| n[0]);
    let image = options.value("image", String::new())?;
    let image = (!image.is_empty()).then(|| image.parse::<ImageFault>());
    let wrong = |error| Failure::new(format!("--option image: {error}"), "choose one of them");
    let presses = options.value("button", Numbers::default())?.exactly([1, 2], "button")?;
    Ok(Faults {
        image: image.transpose().map_err(wrong)?,
        gyro: number("gyro", none.gyro)?,
        stuck: joint("stuck")?,
        hot: joint("hot")?,
        from: number("from", none.from)?,
        until: options
            .value("until", Numbers::default())?
            .exactly([1], "until")?
            .first()
            .copied()
            .unwrap_or(none.until),
        presses: [0, 1].map(|press| presses.get(press).copied().unwrap_or(f32::INFINITY)),
    })
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

impl Numbers {
    /// Checks that there are no numbers, or as many as one of `counts`.
    fn exactly<const N: usize>(self, counts: [usize; N], name: &str) -> Result<Vec<f32>, Failure> {
        if self.0.is_empty() || counts.contains(&self.0.len()) {
            return Ok(self.0);
        }
        let counts = counts.map(|count| count.to_string()).join(" or ");
        let what = format!("--option {name} has {} numbers", self.0.len());
        Err(Failure::new(what, format!("give {counts}, with commas between them")))
    }
}
