//! Parameters of a game.

use std::time::Duration;

use bica::Setting;
use bica_motion::model::NAO;
use bica_motion::model::Profile;
use bica_sim::setup::Frame;

use crate::game::firmware::FirmwareImage;

/// Kind of a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorldKind {
    /// The built-in kinematic world.
    BuiltIn,
    /// `MuJoCo`, with rigid-body dynamics.
    #[cfg(feature = "mujoco")]
    Mujoco,
}

impl WorldKind {
    /// Returns the motion profile of the robot in this world.
    #[must_use]
    pub const fn profile(self) -> &'static Profile {
        match self {
            Self::BuiltIn => NAO.kinematic_profile,
            #[cfg(feature = "mujoco")]
            Self::Mujoco => NAO.dynamic_profile,
        }
    }

    /// Returns the name of the world.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::BuiltIn => "built-in",
            #[cfg(feature = "mujoco")]
            Self::Mujoco => "mujoco",
        }
    }

    /// Returns the name of the motion profile.
    #[must_use]
    pub const fn profile_name(self) -> &'static str {
        match self {
            Self::BuiltIn => "kinematic",
            #[cfg(feature = "mujoco")]
            Self::Mujoco => "dynamic",
        }
    }
}

/// Parameters of a game.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// The world.
    pub world: WorldKind,
    /// Seed of start, light and noise.
    pub seed: u64,
    /// Size of the camera images.
    pub size: Frame,
    /// Number of robots besides the forward and the goalkeeper.
    pub robots: usize,
    /// Longest duration of a game, in simulated time.
    pub limit: Duration,
    /// Whether simulated time follows real time.
    pub realtime: bool,
    /// Firmware that controls the robot in place of this program.
    pub firmware: Option<FirmwareImage>,
    /// Parameters that differ from the defaults, from [`settings`](crate::game::settings).
    pub settings: &'static [Setting],
    /// Options of the world, as `NAME=VALUE`.
    pub options: &'static [String],
}
