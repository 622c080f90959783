//! Simulated body of the robot: ideal, or with forces.

use bica_app::Failure;
use bica_body::ideal::IdealBody;
#[cfg(feature = "mujoco")]
use bica_body::{
    Posture,
    mujoco::{Error, Humanoid, Model, Physics},
    random::Random,
};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Sensors;
#[cfg(feature = "mujoco")]
use bica_motion::{pose::Pose2, robot};

use crate::body::REST;
use crate::robot::Command;

/// Simulated body.
pub(super) enum Body {
    /// Body that follows its targets exactly. It always stands unless it is pushed over.
    Ideal(IdealBody),
    /// Rigid bodies in MuJoCo.
    #[cfg(feature = "mujoco")]
    Forces(Box<Humanoid>),
}

impl Default for Body {
    fn default() -> Self {
        Self::Ideal(IdealBody::new(NAO.robot, REST))
    }
}

impl Body {
    /// Creates a body and a floor from a seed: friction 0.6 to 1.2, gains of the leg motors 0.8 to 1.2, torque limits
    /// 0.8 to 1.1 of the usual ones, dead time 20 to 40 ms. Our choice: robots and floors vary by more than the noise
    /// of the sensors.
    #[cfg(feature = "mujoco")]
    pub(super) fn with_forces(seed: u64) -> Result<Self, Failure> {
        let (mut random, usual) = (Random::new(seed, 1_u64), Physics::of(NAO));
        let mut between = |low, high| random.between(low, high);
        let physics = Physics {
            friction: between(0.6, 1.2),
            leg_gain: between(0.8, 1.2),
            torque_limit: usual.torque_limit * between(0.8, 1.1),
            dead_time: between(0.02, 0.04),
            cameras: false,
            ..usual
        };
        let failed = |error: Error| Failure::new(error.to_string(), "install it anew");
        let (model, noise) = (Model::on_floor(NAO, &physics).map_err(failed)?, Random::new(seed, 0_u64));
        Ok(Self::Forces(Box::new(Humanoid::new(NAO, model, Pose2::ORIGIN, noise, &physics, |_| ()))))
    }

    /// Returns an error: the program was built without MuJoCo.
    #[cfg(not(feature = "mujoco"))]
    pub(super) fn with_forces(_: u64) -> Result<Self, Failure> {
        let help = "`cargo xtask mujoco` installs MuJoCo; then build with `--features mujoco`";
        Err(Failure::new("this program was built without MuJoCo", help))
    }

    /// Measurements of this cycle.
    pub(super) fn sense(&self) -> Sensors<'static> {
        match self {
            Self::Ideal(body) => body.sensors(),
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => humanoid.sensors(),
        }
    }

    /// Executes a command for one cycle. Returns whether the robot falls.
    pub(super) fn act(&mut self, command: &Command) -> bool {
        match self {
            Self::Ideal(body) => {
                body.act(&command.targets);
                false
            }
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => {
                let command =
                    robot::Command { stiffness: command.stiffness, ..robot::Command::new(command.targets, 1.0) };
                matches!(humanoid.act(&command), Some(Posture::Down(_)))
            }
        }
    }

    /// Returns why the simulation cannot continue; `None` if it can.
    pub(super) fn failure(&self) -> Option<&str> {
        match self {
            Self::Ideal(_) => None,
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => humanoid.failure(),
        }
    }

    /// Pushes the robot over, or sets it upright.
    pub(super) fn push_over(&mut self, over: bool) {
        match self {
            Self::Ideal(body) => body.push_over(over),
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) if over => humanoid.add_velocity(glam::Vec2::new(-2.0, 0.0)),
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => humanoid.stand(Pose2::ORIGIN),
        }
    }
}
