//! Errors and shares of the particle filter.

/// Errors and shares of the particle filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalizerTuning {
    /// Standard deviation of a walked distance, per metre.
    pub distance_noise: f32,
    /// Standard deviation of a turn, per radian.
    pub turn_noise: f32,
    /// Standard deviation of the heading after walking, rad/m.
    pub turn_noise_of_distance: f32,
    /// Standard deviation of the position after turning, m/rad.
    pub distance_noise_of_turn: f32,
    /// Standard deviation of a horizontal direction, rad, above 0.
    pub azimuth_error: f32,
    /// Standard deviation of a direction below the horizon, rad, above 0.
    pub elevation_error: f32,
    /// Exponent that flattens the likelihood, because consecutive images are not independent; above 0.
    pub temper: f32,
    /// Minimum share of new particles per image.
    pub new_share: f32,
    /// Minimum share of new particles per image while the pose is not sure.
    pub new_share_if_unsure: f32,
    /// Minimum share of particles near a pose that counts as sure.
    pub sure_share: f32,
}

impl LocalizerTuning {
    /// The default values.
    pub const DEFAULT: Self = Self {
        distance_noise: 0.15,
        turn_noise: 0.1,
        turn_noise_of_distance: 0.1,
        distance_noise_of_turn: 0.03,
        azimuth_error: 0.04,
        elevation_error: 0.012,
        temper: 0.5,
        new_share: 0.03,
        new_share_if_unsure: 0.15,
        sure_share: 0.6,
    };
}
