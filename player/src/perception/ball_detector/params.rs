//! Parameters of the ball detector.

use bica::prelude::*;
use bica_vision::memory::{BallMemoryTuning, MemoryTuning};

use crate::perception::Odometry;

/// Memory of a ball.
#[derive(Params)]
pub struct BallTracking {
    /// Time that halves the confidence in a ball not seen.
    #[param(default = 2.0, range = 0.1..=60.0, unit = "s", step = 0.1)]
    pub(super) half_life: f32,
    /// Walked distance that halves the confidence; odometry drifts by about a tenth.
    #[param(default = 3.0, range = 0.1..=100.0, unit = "m", step = 0.1)]
    pub(super) halving_distance: f32,
    /// Turn that halves the confidence.
    #[param(default = 6.0, range = 0.1..=100.0, unit = "rad", step = 0.1)]
    pub(super) halving_turn: f32,
    /// Factor on the confidence after a sharp image that should show a ball and does not.
    #[param(default = 0.75, range = 0.0..=1.0, step = 0.05)]
    pub(super) miss_factor: f32,
    /// Distance up to which a ball in view is always detected.
    #[param(default = 2.5, range = 0.0..=10.0, unit = "m", step = 0.1)]
    pub(super) visible_distance: f32,
    /// Deceleration of a rolling ball.
    #[param(default = 0.3, range = 0.05..=3.0, unit = "m/s²", step = 0.01)]
    pub(super) deceleration: f32,
    /// Standard deviation of the velocity of a ball just kicked, in each direction.
    #[param(default = 1.0, range = 0.1..=5.0, unit = "m/s", step = 0.1)]
    pub(super) kick_speed: f32,
    /// Rate at which a resting ball starts to roll.
    #[param(default = 0.05, range = 0.0..=5.0, unit = "1/s", step = 0.01)]
    pub(super) kick_rate: f32,
    /// Rate at which a fast ball stops, at an obstacle.
    #[param(default = 0.2, range = 0.0..=5.0, unit = "1/s", step = 0.05)]
    pub(super) stop_rate: f32,
}

impl BallTracking {
    pub(super) const fn tuning(&self, odometry: &Odometry) -> BallMemoryTuning {
        let memory = MemoryTuning {
            half_life: self.half_life,
            halving_distance: self.halving_distance,
            halving_turn: self.halving_turn,
            miss_factor: self.miss_factor,
            distance_error: odometry.distance_error(),
            turn_error: odometry.turn_error(),
        };
        BallMemoryTuning {
            memory,
            deceleration: self.deceleration,
            kick_speed: self.kick_speed,
            kick_rate: self.kick_rate,
            stop_rate: self.stop_rate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_values_are_those_of_detector() {
        let memory = MemoryTuning { half_life: 2.0, ..MemoryTuning::DEFAULT };
        let tuning = BallTracking::DEFAULT.tuning(&Odometry::new());
        assert_eq!(tuning, BallMemoryTuning { memory, ..BallMemoryTuning::DEFAULT });
    }
}
