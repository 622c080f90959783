//! Tuned parameters of all motions.

use crate::model::{Calibration, Kicks, Parameters};

/// Everything about motion that was tuned in one world or on one robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    /// Parameters of walk and stand.
    pub gait: Parameters,
    /// Key poses of the kicks.
    pub kicks: Kicks,
    /// Scales of the odometry.
    pub odometry: Calibration,
}
