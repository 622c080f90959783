//! Choices that an operator has in modulations.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickKind};
use bica_motion::side::Side;

/// Side of the body, as an argument of a modulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ParamEnum)]
pub enum SideChoice {
    /// Left side of the robot.
    Left,
    /// Right side of the robot.
    Right,
}

impl From<SideChoice> for Side {
    fn from(side: SideChoice) -> Self {
        match side {
            SideChoice::Left => Self::Left,
            SideChoice::Right => Self::Right,
        }
    }
}

/// Direction of a kick, as an argument of a modulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ParamEnum)]
pub enum KickChoice {
    /// Straight ahead.
    Front,
    /// Ahead and to the side of the support foot, 45°.
    Diagonal,
    /// To the side of the support foot, 90°.
    Lateral,
}

impl KickChoice {
    /// The kick in this direction with a foot.
    #[must_use]
    pub fn with(self, foot: SideChoice) -> Kick {
        let kind = match self {
            Self::Front => KickKind::Front,
            Self::Diagonal => KickKind::Diagonal,
            Self::Lateral => KickKind::Lateral,
        };
        Kick { kind, foot: foot.into() }
    }
}
