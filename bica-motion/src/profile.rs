//! What differs from world to world and from robot to robot.

use crate::kick::Kicks;
use crate::odometry::Calibration;
use crate::walk::Parameters;

/// Everything about moving that was tried out in one world or with one robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    /// How it walks and stands.
    pub gait: Parameters,
    /// How it kicks.
    pub kicks: Kicks,
    /// How its odometry is corrected.
    pub odometry: Calibration,
}

impl Profile {
    /// The built-in world, where nothing has momentum.
    pub const BUILT_IN: Self =
        Self { gait: Parameters::BUILT_IN, kicks: Kicks::BUILT_IN, odometry: Calibration::EXACT };
    /// A NAO with real forces, as in `MuJoCo`.
    pub const NAO: Self = Self { gait: Parameters::NAO, kicks: Kicks::NAO, odometry: Calibration::NAO };
}
