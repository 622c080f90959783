//! Adjustment of a gait to a floor.

use crate::model::Parameters;
use crate::velocity::Velocity;

/// Scales and offsets on top of the parameters of a gait. With [`NONE`](Self::NONE) the walk follows the gait exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adjustment {
    /// Scale of the maximum speeds, above zero.
    pub speed_limit: f32,
    /// Scale of the height of the swing foot, above zero.
    pub step_height: f32,
    /// Scale of the gains from the gyroscope to the ankles.
    pub balance: f32,
    /// Additional forward lean of the torso, rad.
    pub torso_lean: f32,
}

impl Adjustment {
    /// No adjustment.
    pub const NONE: Self = Self { speed_limit: 1.0, step_height: 1.0, balance: 1.0, torso_lean: 0.0 };

    /// Nearest velocity within the scaled limits of a gait.
    pub(super) fn clamped(&self, request: Velocity, gait: &Parameters) -> Velocity {
        let scale = self.speed_limit;
        let within = Velocity::new(request.forward / scale, request.left / scale, request.turn / scale).clamped(gait);
        Velocity::new(within.forward * scale, within.left * scale, within.turn * scale)
    }
}
