//! Parameters of the goal detector.

use bica::prelude::*;
use bica_vision::memory::MemoryTuning;

use crate::perception::Odometry;

/// Memory of a goal.
#[derive(Params)]
pub struct GoalTracking {
    /// Time that halves the confidence in a goal not seen.
    #[param(default = 20.0, range = 0.1..=600.0, unit = "s", step = 0.1)]
    pub(super) half_life: f32,
    /// Walked distance that halves the confidence; odometry drifts by about a tenth.
    #[param(default = 3.0, range = 0.1..=100.0, unit = "m", step = 0.1)]
    pub(super) halving_distance: f32,
    /// Turn that halves the confidence.
    #[param(default = 6.0, range = 0.1..=100.0, unit = "rad", step = 0.1)]
    pub(super) halving_turn: f32,
    /// Factor on the confidence after a sharp image that should show a goal and does not.
    #[param(default = 0.75, range = 0.0..=1.0, step = 0.05)]
    pub(super) miss_factor: f32,
    /// Distance up to which a goal in view is always detected.
    #[param(default = 4.0, range = 0.0..=10.0, unit = "m", step = 0.1)]
    pub(super) visible_distance: f32,
    /// Maximum correction of the remembered goal by a single post; a farther post belongs to another object.
    #[param(default = 0.6, range = 0.0..=3.0, unit = "m", step = 0.05)]
    pub(super) max_correction: f32,
    /// Confidence in a goal of which both posts are seen.
    #[param(default = 0.9, range = 0.0..=1.0, step = 0.05)]
    pub(super) two_posts_confidence: f32,
    /// Confidence in a goal of which one post is seen.
    #[param(default = 0.3, range = 0.0..=1.0, step = 0.05)]
    pub(super) one_post_confidence: f32,
}

impl GoalTracking {
    pub(super) const fn tuning(&self, odometry: &Odometry) -> MemoryTuning {
        MemoryTuning {
            half_life: self.half_life,
            halving_distance: self.halving_distance,
            halving_turn: self.halving_turn,
            miss_factor: self.miss_factor,
            distance_error: odometry.distance_error(),
            turn_error: odometry.turn_error(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_values_are_those_of_detector() {
        let tuning = GoalTracking::DEFAULT.tuning(&Odometry::new());
        assert_eq!(tuning, MemoryTuning { half_life: 20.0, ..MemoryTuning::DEFAULT });
    }
}
