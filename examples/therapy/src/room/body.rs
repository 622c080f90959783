//! The body of the robot in the room: ideal, or with forces.

use bica_app::Failure;
#[cfg(feature = "mujoco")]
use bica_body::{
    Posture,
    mujoco::{Humanoid, Model, Physics},
    random::Random,
};
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::model::Nao;
use bica_motion::pose::Pose2;
#[cfg(feature = "mujoco")]
use bica_motion::robot;
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};

use crate::body::REST;
use crate::robot::Command;

/// Temperature of a motor without a load, °C.
const COOL: f32 = 38.0;
/// Force of a standing robot on a sensor of a sole, N.
const LOAD: f32 = 6.5;

/// A body.
pub(super) enum Body {
    /// Follows its targets, and always stands unless it is pushed over.
    Ideal { angles: Joints, fallen: bool },
    /// Rigid bodies in MuJoCo.
    #[cfg(feature = "mujoco")]
    Forces { humanoid: Box<Humanoid<Nao>>, falls: usize },
}

impl Body {
    pub(super) const fn ideal() -> Self {
        Self::Ideal { angles: REST, fallen: false }
    }

    /// A body and a floor of a seed: friction 0.6 to 1.2, gains of the leg motors 0.8 to 1.2 and their torque 0.8 to 1.1 of the usual,
    /// dead time 20 to 40 ms. Our choice: robots and floors that differ more than the noise of the sensors.
    ///
    /// # Errors
    /// If MuJoCo rejects its model.
    #[cfg(feature = "mujoco")]
    pub(super) fn with_forces(seed: u64) -> Result<Self, Failure> {
        let (mut random, usual) = (Random::new(seed, 1_u64), Physics::of::<Nao>());
        let mut between = |low, high| random.between(low, high);
        let physics = Physics {
            friction: between(0.6, 1.2),
            leg_gain: between(0.8, 1.2),
            torque_limit: usual.torque_limit * between(0.8, 1.1),
            dead_time: between(0.02, 0.04),
            cameras: false,
            ..usual
        };
        let failed = |error: bica_body::mujoco::Error| Failure::new(error.to_string(), "install it anew");
        let (model, noise) = (Model::on_floor::<Nao>(&physics).map_err(failed)?, Random::new(seed, 0_u64));
        let humanoid = Box::new(Humanoid::new(model, Pose2::ORIGIN, noise, &physics, |_| ()));
        Ok(Self::Forces { humanoid, falls: 0 })
    }

    /// # Errors
    /// Always: there is no MuJoCo.
    #[cfg(not(feature = "mujoco"))]
    pub(super) fn with_forces(_: u64) -> Result<Self, Failure> {
        let help = "`cargo xtask mujoco` installs MuJoCo; then build with `--features mujoco`";
        Err(Failure::new("this program was built without MuJoCo", help))
    }

    pub(super) fn place(&self) -> Pose2 {
        match self {
            Self::Ideal { .. } => Pose2::ORIGIN,
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, .. } => humanoid.ground_pose(),
        }
    }

    /// How often the robot fell.
    pub(super) const fn falls(&self) -> usize {
        match self {
            Self::Ideal { .. } => 0,
            #[cfg(feature = "mujoco")]
            Self::Forces { falls, .. } => *falls,
        }
    }

    /// Measurements of this cycle.
    pub(super) fn sense(&self) -> Sensors<'static> {
        match self {
            Self::Ideal { angles, fallen } => {
                let foot = FootPressure { front_left: LOAD, front_right: LOAD, rear_left: LOAD, rear_right: LOAD };
                Sensors {
                    angles: *angles,
                    temperatures: Joints([COOL; JOINTS]),
                    currents: Joints([0.0; JOINTS]),
                    inertial: Inertial { pitch: if *fallen { 1.5 } else { 0.0 }, ..Inertial::default() },
                    left_foot: foot,
                    right_foot: foot,
                    buttons: Buttons::default(),
                    image: None,
                }
            }
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, .. } => humanoid.sensors(),
        }
    }

    /// Executes a command for a cycle.
    pub(super) fn act(&mut self, command: &Command) {
        match self {
            Self::Ideal { angles, .. } => *angles = angles.moved_toward::<Nao>(&command.targets, 0.01),
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, falls } => {
                let Command { targets, stiffness, .. } = *command;
                let command = robot::Command { targets, stiffness, ..robot::Command::new(targets, 1.0) };
                *falls += usize::from(matches!(humanoid.act(&command), Some(Posture::Down(_))));
            }
        }
    }

    /// True angles, rad.
    pub(super) fn angles(&self) -> Joints {
        match self {
            Self::Ideal { angles, .. } => *angles,
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, .. } => humanoid.angles(),
        }
    }

    /// Pushes the robot over, or puts it on its feet.
    pub(super) fn push_over(&mut self, over: bool) {
        match self {
            Self::Ideal { fallen, .. } => *fallen = over,
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, .. } if over => humanoid.add_velocity(glam::Vec2::new(-2.0, 0.0)),
            #[cfg(feature = "mujoco")]
            Self::Forces { humanoid, .. } => humanoid.stand(Pose2::ORIGIN),
        }
    }
}
