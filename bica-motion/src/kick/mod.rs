//! Six fixed kicks: ahead, to the front of the other side, and to the other side, with either foot.
//!
//! A kick begins and ends in the stand of the walk, keeps the centre of mass over the standing foot at every moment, and
//! asks no joint for more than its speed.

mod frames;
mod motion;
mod pose;

pub use motion::KickMotion;

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::Vec2;

use self::frames::{DIAGONAL, FRONT, Frame, LATERAL};
use crate::side::Side;

/// Where a kick sends the ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum KickKind {
    /// Straight ahead.
    Front,
    /// Ahead and to the side of the standing foot.
    Diagonal,
    /// To the side of the standing foot.
    Lateral,
}

/// One of the six kicks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Kick {
    /// Where to.
    pub kind: KickKind,
    /// The foot that kicks; the other one stands.
    pub foot: Side,
}

impl Kick {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self { kind: KickKind::Front, foot: Side::Left },
        Self { kind: KickKind::Front, foot: Side::Right },
        Self { kind: KickKind::Diagonal, foot: Side::Left },
        Self { kind: KickKind::Diagonal, foot: Side::Right },
        Self { kind: KickKind::Lateral, foot: Side::Left },
        Self { kind: KickKind::Lateral, foot: Side::Right },
    ];

    /// Where the ball's middle must be, m, in the frame of the ground between the feet of the stand before the kick.
    ///
    /// Within 15 mm of it the kick still works.
    #[must_use]
    pub const fn ball(self) -> Vec2 {
        let (x, y) = match self.kind {
            KickKind::Front => (0.170, 0.060),
            KickKind::Diagonal => (0.155, -0.014),
            KickKind::Lateral => (0.155, 0.002),
        };
        Vec2::new(x, self.foot.sign() * y)
    }

    /// The direction in which the ball flies, rad, positive to the left, in the same frame as [`ball`](Self::ball).
    #[must_use]
    pub const fn direction(self) -> f32 {
        let aside = match self.kind {
            KickKind::Front => 0.0,
            KickKind::Diagonal => FRAC_PI_4,
            KickKind::Lateral => FRAC_PI_2,
        };
        -self.foot.sign() * aside
    }

    /// From stand to stand, s.
    #[must_use]
    pub fn seconds(self) -> f32 {
        self.frames().iter().map(|frame| frame.0).sum()
    }

    const fn frames(self) -> &'static [Frame] {
        match self.kind {
            KickKind::Front => &FRONT,
            KickKind::Diagonal => &DIAGONAL,
            KickKind::Lateral => &LATERAL,
        }
    }
}
