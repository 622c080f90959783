//! Six fixed kicks: ahead, to the front of the other side, and to the other side, with either foot.
//!
//! A kick begins and ends in the stand of the walk and keeps the centre of mass over the standing foot at every moment.
//! How it is done differs from world to world: [`Kicks`].

mod forces;
mod frames;
mod motion;
mod pose;
mod technique;

pub use motion::KickMotion;
pub use technique::Kicks;

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::Vec2;

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
    pub const fn ball(self, kicks: &Kicks) -> Vec2 {
        let ball = kicks.of(self.kind).ball;
        Vec2::new(ball.x, self.foot.sign() * ball.y)
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
}
