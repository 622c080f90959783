//! Parameters of the detector of robots.

use bica::prelude::*;
use bica_vision::memory::MemoryTuning;

use crate::perception::Odometry;

/// Memory of a robot.
#[derive(Params)]
pub struct RobotTracking {
    /// Time that halves the confidence in a robot not seen.
    #[param(default = 4.0, range = 0.1..=60.0, unit = "s", step = 0.1)]
    pub(super) half_life: f32,
    /// Walked distance that halves the confidence; odometry drifts by about a tenth.
    #[param(default = 3.0, range = 0.1..=100.0, unit = "m", step = 0.1)]
    pub(super) halving_distance: f32,
    /// Turn that halves the confidence.
    #[param(default = 6.0, range = 0.1..=100.0, unit = "rad", step = 0.1)]
    pub(super) halving_turn: f32,
    /// Factor on the confidence after a sharp image that should show a robot and does not.
    #[param(default = 0.75, range = 0.0..=1.0, step = 0.05)]
    pub(super) miss_factor: f32,
    /// Distance up to which a robot in view is always detected.
    #[param(default = 2.0, range = 0.0..=10.0, unit = "m", step = 0.1)]
    pub(super) visible_distance: f32,
    /// Confidence in a robot that is seen.
    #[param(default = 0.8, range = 0.0..=1.0, step = 0.05)]
    pub(super) sighting_confidence: f32,
    /// Standard deviation from the edge of a robot's feet to its middle.
    #[param(default = 0.1, range = 0.01..=0.5, unit = "m", step = 0.01)]
    pub(super) width_error: f32,
}

impl RobotTracking {
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
    fn values_are_passed_to_the_memory() {
        let tracking = RobotTracking { miss_factor: 0.5, ..RobotTracking::DEFAULT };
        assert_eq!(tracking.tuning(&Odometry::new()).miss_factor.to_bits(), 0.5_f32.to_bits());
    }

    #[test]
    fn default_values_are_those_of_detector() {
        let tuning = RobotTracking::DEFAULT.tuning(&Odometry::new());
        assert_eq!(tuning, MemoryTuning { half_life: 4.0, ..MemoryTuning::DEFAULT });
    }
}
