//! Errors and shares of the particle filter.

use bica_macros::Params;

/// Noise of the motion in the particle filter.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core)]
pub struct MotionNoise {
    /// Standard deviation of a walked distance, per metre.
    #[param(default = 0.15, range = 0.0..=1.0, step = 0.01)]
    pub distance_noise: f32,
    /// Standard deviation of a turn, per radian.
    #[param(default = 0.1, range = 0.0..=1.0, step = 0.01)]
    pub turn_noise: f32,
    /// Standard deviation of the heading after walking.
    #[param(default = 0.1, range = 0.0..=1.0, unit = "rad/m", step = 0.01)]
    pub turn_noise_of_distance: f32,
    /// Standard deviation of the position after turning.
    #[param(default = 0.03, range = 0.0..=1.0, unit = "m/rad", step = 0.01)]
    pub distance_noise_of_turn: f32,
}

/// Use of sightings in the particle filter.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core, check = Self::is_ordered)]
pub struct SightingUse {
    /// Standard deviation of a horizontal direction.
    #[param(default = 0.04, range = 0.005..=0.5, unit = "rad", step = 0.005)]
    pub azimuth_error: f32,
    /// Standard deviation of a direction below the horizon.
    #[param(default = 0.012, range = 0.002..=0.2, unit = "rad", step = 0.002)]
    pub elevation_error: f32,
    /// Exponent that flattens the likelihood, because consecutive images are not independent.
    #[param(default = 0.5, range = 0.05..=1.0, step = 0.05)]
    pub temper: f32,
    /// Minimum share of new particles per image.
    #[param(default = 0.03, range = 0.0..=0.5, step = 0.01)]
    pub new_share: f32,
    /// Minimum share of new particles per image while the pose is not sure.
    #[param(default = 0.15, range = 0.0..=0.5, step = 0.01)]
    pub new_share_if_unsure: f32,
    /// Minimum share of particles near a pose that is sure.
    #[param(default = 0.6, range = 0.1..=1.0, step = 0.05)]
    pub sure_share: f32,
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

#[cfg(test)]
mod tests {
    use bica_core::Params;

    use super::*;

    #[test]
    fn a_pose_can_be_sure() {
        let sightings = SightingUse::DEFAULT;
        assert!(SightingUse { new_share: 0.16, ..sightings }.is_ordered().is_err());
        assert!(SightingUse { sure_share: 0.98, ..sightings }.is_ordered().is_err());
        assert!(SightingUse { sure_share: 0.96, ..sightings }.is_ordered().is_ok());
    }
}
