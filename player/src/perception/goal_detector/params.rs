//! Parameters of the goal detector.

use bica::prelude::*;
use bica_vision::goal::GoalTuning;
use bica_vision::memory::MemoryTuning;
use bica_vision::uncertainty::Errors;

use crate::perception::Odometry;

/// Detection of goals in an image.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct GoalDetection {
    /// Minimum height of a post, as a share of the image height.
    #[param(default = 0.05, range = 0.0..=0.5, step = 0.01)]
    pub(super) min_post_height: f32,
    /// Minimum width of a post, relative to the expected width at its position.
    #[param(default = 0.6, range = 0.0..=1.0, step = 0.05)]
    pub(super) min_post_width: f32,
    /// Maximum width of a post, relative to the expected width at its position.
    #[param(default = 1.6, range = 1.0..=4.0, step = 0.05)]
    pub(super) max_post_width: f32,
    /// Tolerated error of the camera's pitch in the tests of posts.
    #[param(default = 0.04, range = 0.0..=0.3, unit = "rad", step = 0.005)]
    pub(super) pitch_error: f32,
    /// Maximum relative error of the distance between two posts of one goal.
    #[param(default = 0.3, range = 0.0..=1.0, step = 0.05)]
    pub(super) max_width_error: f32,
    /// Minimum width of a gap to aim at, relative to the goal.
    #[param(default = 0.25, range = 0.0..=1.0, step = 0.05)]
    pub(super) min_gap: f32,
}

impl GoalDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_post_width < self.max_post_width {
            Ok(())
        } else {
            Err("`min_post_width` must be below `max_post_width`")
        }
    }

    pub(super) const fn tuning(&self, errors: Errors) -> GoalTuning {
        GoalTuning {
            min_post_height: self.min_post_height,
            min_post_width: self.min_post_width,
            max_post_width: self.max_post_width,
            pitch_error: self.pitch_error,
            errors,
        }
    }
}

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
    fn values_are_passed_to_the_detector() {
        let detection = GoalDetection { max_post_width: 2.0, pitch_error: 0.1, ..GoalDetection::DEFAULT };
        let tuning = GoalTuning { max_post_width: 2.0, pitch_error: 0.1, ..GoalTuning::DEFAULT };
        assert_eq!(detection.tuning(Errors::NAO), tuning);
    }

    #[test]
    fn default_values_are_those_of_detector() {
        assert_eq!(GoalDetection::DEFAULT.tuning(Errors::NAO), GoalTuning::DEFAULT);
        let tuning = GoalTracking::DEFAULT.tuning(&Odometry::new());
        assert_eq!(tuning, MemoryTuning { half_life: 20.0, ..MemoryTuning::DEFAULT });
    }

    #[test]
    fn a_post_has_a_width() {
        assert!(
            GoalDetection { min_post_width: 1.0, max_post_width: 1.0, ..GoalDetection::DEFAULT }.is_ordered().is_err()
        );
    }
}
