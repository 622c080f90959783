//! Parameters of the alignment before a kick.

use bica::prelude::*;
use bica::visual::Pose2;
use bica_motion::bounds::clamp;
use bica_motion::kick::{Kick, Kicks};
use bica_motion::walk::Velocity;
use glam::Vec2;
use libm::fabsf;

/// How the robot lines up with the ball before a kick.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct LineUp {
    /// Largest position error of the ball before a kick, forward and sideways each.
    #[param(default = 0.015, range = 0.003..=0.06, unit = "m", step = 0.001)]
    pub position_tolerance: f32,
    /// Largest heading error before a kick.
    #[param(default = 0.08, range = 0.01..=0.5, unit = "rad", step = 0.01)]
    pub heading_tolerance: f32,
    /// Speed per position error.
    #[param(default = 1.5, range = 0.1..=5.0, unit = "1/s", step = 0.1)]
    pub position_gain: f32,
    /// Turning speed per heading error.
    #[param(default = 1.2, range = 0.1..=5.0, unit = "1/s", step = 0.1)]
    pub heading_gain: f32,
    /// Largest correction speed, forward and sideways each.
    #[param(default = 0.08, range = 0.02..=0.2, unit = "m/s", step = 0.01)]
    pub max_speed: f32,
    /// Largest turning speed.
    #[param(default = 0.5, range = 0.05..=1.5, unit = "rad/s", step = 0.05)]
    pub max_turn: f32,
    /// Backward speed after an alignment that failed.
    #[param(default = 0.08, range = 0.02..=0.2, unit = "m/s", step = 0.01)]
    pub retreat_speed: f32,
    /// Distance of the ball beyond which it has to be approached again.
    #[param(default = 0.5, range = 0.2..=2.0, unit = "m", step = 0.05)]
    pub far_distance: f32,
    /// Number of aligned runs at rest before the kick, 30 in a second: time for some images of the ball.
    #[param(default = 8, range = 1..=60)]
    pub settled_runs: u32,
    /// Forward correction of the position of the ball in all kicks of the profile.
    #[param(default = 0.0, range = -0.05..=0.05, unit = "m", step = 0.002)]
    pub ball_forward_offset: f32,
    /// Correction of the position of the ball in all kicks of the profile, to the side of the kicking foot.
    #[param(default = 0.0, range = -0.05..=0.05, unit = "m", step = 0.002)]
    pub ball_outward_offset: f32,
}

impl LineUp {
    /// Required position of the ball, m, in the ground frame of the stand before the kick.
    pub(super) fn ball(&self, kick: Kick, kicks: &Kicks) -> Vec2 {
        kick.ball(kicks) + Vec2::new(self.ball_forward_offset, kick.foot.sign() * self.ball_outward_offset)
    }

    /// Velocity that reduces an error: forward and to the left, m, and in heading, rad.
    pub(super) fn velocity(&self, error: &Pose2) -> Velocity {
        Velocity {
            forward: clamp(self.position_gain * error.x, -self.max_speed, self.max_speed),
            left: clamp(self.position_gain * error.y, -self.max_speed, self.max_speed),
            turn: clamp(self.heading_gain * error.heading, -self.max_turn, self.max_turn),
        }
    }

    /// Whether the error allows a kick.
    pub(super) fn allows(&self, error: &Pose2) -> bool {
        fabsf(error.x) < self.position_tolerance
            && fabsf(error.y) < self.position_tolerance
            && fabsf(error.heading) < self.heading_tolerance
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::kick::KickKind;
    use bica_motion::side::Side;

    use super::*;
    use crate::MODEL;

    #[test]
    fn tolerances_gains_and_limits_are_tuned_ones() {
        let error = Pose2 { x: 0.02, y: -0.02, heading: 0.05 };
        let tuned = LineUp { position_tolerance: 0.03, position_gain: 2.0, max_turn: 0.05, ..LineUp::DEFAULT };
        assert!(tuned.allows(&error) && !LineUp::DEFAULT.allows(&error));
        assert!(!tuned.allows(&Pose2 { heading: 0.09, ..error }) && !tuned.allows(&Pose2 { y: -0.04, ..error }));
        assert_eq!(tuned.velocity(&error), Velocity { forward: 0.04, left: -0.04, turn: 0.05 });
    }

    #[test]
    fn ball_offset_is_mirrored_for_right_foot() {
        let kicks = &MODEL.kinematic_profile.kicks;
        let tuned = LineUp { ball_forward_offset: 0.01, ball_outward_offset: 0.02, ..LineUp::DEFAULT };
        for (foot, outward) in [(Side::Left, 0.02), (Side::Right, -0.02)] {
            let kick = Kick { kind: KickKind::Diagonal, foot };
            let offset = tuned.ball(kick, kicks) - kick.ball(kicks);
            assert!(offset.distance(Vec2::new(0.01, outward)) < 1e-6, "{foot:?}: {offset}");
            assert_eq!(LineUp::DEFAULT.ball(kick, kicks), kick.ball(kicks));
        }
    }
}
