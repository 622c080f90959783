//! How kicks are done.

use glam::Vec2;

use super::KickKind;
use super::pose::Frame;
use super::{forces, frames};

/// How the three kinds of kicks are done: one for each world or robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kicks {
    pub(super) front: Technique,
    pub(super) diagonal: Technique,
    pub(super) lateral: Technique,
}

/// How one kick is done, with the left foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Technique {
    /// Where the ball must be, m.
    pub(super) ball: Vec2,
    /// The poses; the one with index [`STRIKE`] is the strike. The stand follows.
    pub(super) frames: &'static [Frame],
}

/// The frame that is the strike, in each list.
pub(super) const STRIKE: usize = 3;

impl Kicks {
    /// In the built-in world, where a foot's speed alone counts. They ask no joint for more than its speed.
    pub const BUILT_IN: Self = Self {
        front: Technique { ball: Vec2::new(0.170, 0.060), frames: &frames::FRONT },
        diagonal: Technique { ball: Vec2::new(0.155, -0.014), frames: &frames::DIAGONAL },
        lateral: Technique { ball: Vec2::new(0.155, 0.002), frames: &frames::LATERAL },
    };

    /// A NAO with real forces.
    pub const NAO: Self = Self {
        front: Technique { ball: Vec2::new(0.170, 0.060), frames: &forces::FRONT },
        diagonal: Technique { ball: Vec2::new(0.158, -0.025), frames: &forces::DIAGONAL },
        lateral: Technique { ball: Vec2::new(0.156, -0.002), frames: &forces::LATERAL },
    };

    pub(super) const fn of(&self, kind: KickKind) -> &Technique {
        match kind {
            KickKind::Front => &self.front,
            KickKind::Diagonal => &self.diagonal,
            KickKind::Lateral => &self.lateral,
        }
    }
}
