//! Six fixed kicks: ahead, diagonal and lateral, with either foot.
//!
//! A kick begins and ends in the stand of the walk and keeps the centre of mass over the support foot at every moment. The
//! key poses differ from world to world: [`Kicks`].

mod motion;
mod pose;

pub use crate::model::Kicks;
pub use motion::KickMotion;

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::Vec2;

use crate::model::Technique;
use crate::side::Side;

/// Direction of a kick.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub enum KickKind {
    /// Straight ahead.
    Front,
    /// Ahead and to the side of the support foot, 45°.
    Diagonal,
    /// To the side of the support foot, 90°.
    Lateral,
}

/// One of the six kicks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub struct Kick {
    /// Direction.
    pub kind: KickKind,
    /// Kicking foot; the other one is the support foot.
    pub foot: Side,
}

impl Kick {
    /// All six kicks.
    pub const ALL: [Self; 6] = [
        Self { kind: KickKind::Front, foot: Side::Left },
        Self { kind: KickKind::Front, foot: Side::Right },
        Self { kind: KickKind::Diagonal, foot: Side::Left },
        Self { kind: KickKind::Diagonal, foot: Side::Right },
        Self { kind: KickKind::Lateral, foot: Side::Left },
        Self { kind: KickKind::Lateral, foot: Side::Right },
    ];

    /// Required position of the ball's centre, m, in the frame of the ground between the feet of the stand before the kick.
    ///
    /// The tolerance is 15 mm.
    #[must_use]
    pub const fn ball(self, kicks: &Kicks) -> Vec2 {
        let ball = technique(kicks, self.kind).ball;
        Vec2::new(ball.x, self.foot.sign() * ball.y)
    }

    /// Direction of the ball after the kick, rad, positive to the left, in the frame of [`ball`](Self::ball).
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

/// The technique of a kind of kick.
#[must_use]
pub const fn technique(kicks: &Kicks, kind: KickKind) -> &Technique {
    match kind {
        KickKind::Front => &kicks.front,
        KickKind::Diagonal => &kicks.diagonal,
        KickKind::Lateral => &kicks.lateral,
    }
}
