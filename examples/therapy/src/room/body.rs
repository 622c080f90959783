//! Simulated body of the robot: ideal, or with forces.

use bica_app::Failure;
#[cfg(feature = "mujoco")]
use bica_body::{
    Posture,
    mujoco::{Error, Humanoid, Model, Physics},
    random::Random,
};
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::kinematics::sole;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
#[cfg(feature = "mujoco")]
use bica_motion::{pose::Pose2, robot};

use crate::body::REST;
use crate::robot::Command;

/// Temperature of a motor without a load, °C.
const COOL: f32 = 38.0;
/// Force of a standing robot on a sensor of a sole, N.
const LOAD: f32 = 6.5;
/// Height above the other sole from which a foot bears no weight, m. Without this limit the odometry would not detect steps.
const SWING: f32 = 0.002;

/// Simulated body.
pub(super) enum Body {
    /// Body that follows its targets exactly. It always stands unless it is pushed over.
    Ideal { angles: Joints, fallen: bool },
    /// Rigid bodies in MuJoCo.
    #[cfg(feature = "mujoco")]
    Forces(Box<Humanoid>),
}

impl Default for Body {
    fn default() -> Self {
        Self::Ideal { angles: REST, fallen: false }
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
        let (angles, fallen) = match self {
            Self::Ideal { angles, fallen } => (*angles, *fallen),
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => return humanoid.sensors(),
        };
        let [left, right] = Side::BOTH.map(|side| sole(NAO, side, &angles).translation.z);
        let foot = |higher: f32| {
            let load = if higher > SWING { 0.0 } else { LOAD };
            FootPressure { front_left: load, front_right: load, rear_left: load, rear_right: load }
        };
        Sensors {
            angles,
            temperatures: Joints([COOL; JOINTS]),
            currents: Joints([0.0; JOINTS]),
            inertial: Inertial { pitch: if fallen { 1.5 } else { 0.0 }, ..Inertial::default() },
            left_foot: foot(left - right),
            right_foot: foot(right - left),
            buttons: Buttons::default(),
            image: None,
        }
    }

    /// Executes a command for one cycle. Returns whether the robot falls.
    pub(super) fn act(&mut self, command: &Command) -> bool {
        match self {
            Self::Ideal { angles, .. } => {
                *angles = angles.moved_toward(NAO, &command.targets, 0.01);
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
            Self::Ideal { .. } => None,
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => humanoid.failure(),
        }
    }

    /// Pushes the robot over, or sets it upright.
    pub(super) fn push_over(&mut self, over: bool) {
        match self {
            Self::Ideal { fallen, .. } => *fallen = over,
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) if over => humanoid.add_velocity(glam::Vec2::new(-2.0, 0.0)),
            #[cfg(feature = "mujoco")]
            Self::Forces(humanoid) => humanoid.stand(Pose2::ORIGIN),
        }
    }
}
