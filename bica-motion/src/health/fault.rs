//! Faults of the body.

use crate::joints::Joint;
use crate::side::Side;

/// A fault with which a robot must not continue to move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub enum Fault {
    /// A joint of legs or head does not follow its target: it is blocked or too weak, or its sensor is broken.
    Stuck(Joint),
    /// The inertial unit repeats the same reading.
    Inertial,
    /// A foot measures no force although it supports the robot.
    Foot(Side),
    /// The motor of a joint is almost so hot that the robot's firmware would derate it.
    Hot(Joint),
    /// The motor of a joint has drawn more than its continuous current for seconds.
    Overloaded(Joint),
}

impl core::fmt::Display for Fault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Stuck(joint) => write!(f, "{joint:?} does not follow its target"),
            Self::Inertial => f.write_str("the inertial unit is silent"),
            Self::Foot(Side::Left) => f.write_str("the left foot's pressure sensors are silent"),
            Self::Foot(Side::Right) => f.write_str("the right foot's pressure sensors are silent"),
            Self::Hot(joint) => write!(f, "{joint:?} is too hot"),
            Self::Overloaded(joint) => write!(f, "{joint:?} draws too much current"),
        }
    }
}

impl Fault {
    /// Whether the fault can end by itself: faults by heat do.
    #[must_use]
    pub const fn is_temporary(self) -> bool {
        matches!(self, Self::Hot(_) | Self::Overloaded(_))
    }
}
