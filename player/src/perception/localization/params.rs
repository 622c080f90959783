//! Parameters of self-localization.

use bica::prelude::*;
use bica_vision::localization::LocalizerTuning;

/// Noise of the motion in the particle filter.
#[derive(Params)]
pub struct MotionNoise {
    /// Standard deviation of a walked distance, per metre.
    #[param(default = 0.15, range = 0.0..=1.0, step = 0.01)]
    pub(super) distance_noise: f32,
    /// Standard deviation of a turn, per radian.
    #[param(default = 0.1, range = 0.0..=1.0, step = 0.01)]
    pub(super) turn_noise: f32,
    /// Standard deviation of the heading after walking.
    #[param(default = 0.1, range = 0.0..=1.0, unit = "rad/m", step = 0.01)]
    pub(super) turn_noise_of_distance: f32,
    /// Standard deviation of the position after turning.
    #[param(default = 0.03, range = 0.0..=1.0, unit = "m/rad", step = 0.01)]
    pub(super) distance_noise_of_turn: f32,
}

/// Use of sightings in the particle filter.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct SightingUse {
    /// Standard deviation of a horizontal direction.
    #[param(default = 0.04, range = 0.005..=0.5, unit = "rad", step = 0.005)]
    pub(super) azimuth_error: f32,
    /// Standard deviation of a direction below the horizon.
    #[param(default = 0.012, range = 0.002..=0.2, unit = "rad", step = 0.002)]
    pub(super) elevation_error: f32,
    /// Exponent that flattens the likelihood, because consecutive images are not independent.
    #[param(default = 0.5, range = 0.05..=1.0, step = 0.05)]
    pub(super) temper: f32,
    /// Minimum share of new particles per image.
    #[param(default = 0.03, range = 0.0..=0.5, step = 0.01)]
    pub(super) new_share: f32,
    /// Minimum share of new particles per image while the pose is not sure.
    #[param(default = 0.15, range = 0.0..=0.5, step = 0.01)]
    pub(super) new_share_if_unsure: f32,
    /// Minimum share of particles near a pose that is sure.
    #[param(default = 0.6, range = 0.1..=1.0, step = 0.05)]
    pub(super) sure_share: f32,
}

impl SightingUse {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.new_share > self.new_share_if_unsure {
            Err("`new_share` must not be above `new_share_if_unsure`")
        } else if self.new_share >= 1.0 - self.sure_share {
            Err("`new_share` must be below 1 - `sure_share`, or no pose is ever sure")
        } else {
            Ok(())
        }
    }
}

pub(super) const fn tuning(motion: &MotionNoise, sightings: &SightingUse) -> LocalizerTuning {
    LocalizerTuning {
        distance_noise: motion.distance_noise,
        turn_noise: motion.turn_noise,
        turn_noise_of_distance: motion.turn_noise_of_distance,
        distance_noise_of_turn: motion.distance_noise_of_turn,
        azimuth_error: sightings.azimuth_error,
        elevation_error: sightings.elevation_error,
        temper: sightings.temper,
        new_share: sightings.new_share,
        new_share_if_unsure: sightings.new_share_if_unsure,
        sure_share: sightings.sure_share,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_values_are_those_of_filter() {
        assert_eq!(tuning(&MotionNoise::DEFAULT, &SightingUse::DEFAULT), LocalizerTuning::DEFAULT);
    }

    #[test]
    fn a_pose_can_be_sure() {
        let sightings = || SightingUse::DEFAULT;
        assert!(SightingUse { new_share: 0.16, ..sightings() }.is_ordered().is_err());
        assert!(SightingUse { sure_share: 0.98, ..sightings() }.is_ordered().is_err());
        assert!(SightingUse { sure_share: 0.96, ..sightings() }.is_ordered().is_ok());
    }
}
