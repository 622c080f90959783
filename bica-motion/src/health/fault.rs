//! Faults of the body.

use crate::joints::Joint;
use crate::side::Side;

/// A fault with which a robot must not continue to move: [`Health`](super::Health) finds those of the body, with which it sits down, and
/// [`Senses`](super::Senses) those without which it cannot find its way, with which it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub enum Fault {
    /// A joint of legs or head does not follow its target: it is blocked or too weak, or its sensor is broken.
    Stuck(Joint),
    /// The inertial unit repeats the same reading, or sends none that is possible.
    Inertial,
    /// A foot measures no force although it supports the robot.
    Foot(Side),
    /// The motor of a joint is almost so hot that the robot's firmware would derate it.
    Hot(Joint),
    /// The motor of a joint has drawn more than its continuous current for seconds.
    Overloaded(Joint),
    /// The gyroscope measures a turn that the robot does not make: it stands, or its legs turn it less.
    GyroOffset,
    /// The camera sends no images.
    NoImages,
    /// The camera repeats the same image.
    FrozenImage,
    /// The camera's images are black.
    DarkImage,
    /// The camera's images are white.
    BrightImage,
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
            Self::GyroOffset => f.write_str("the gyroscope measures a turn that the robot does not make"),
            Self::NoImages => f.write_str("the camera sends no images"),
            Self::FrozenImage => f.write_str("the camera repeats the same image"),
            Self::DarkImage => f.write_str("the camera's images are black"),
            Self::BrightImage => f.write_str("the camera's images are white"),
        }
    }
}

impl Fault {
    /// Whether the fault can end by itself: all but those of joints, inertial unit and feet.
    #[must_use]
    pub const fn is_temporary(self) -> bool {
        !matches!(self, Self::Stuck(_) | Self::Inertial | Self::Foot(_))
    }
}
