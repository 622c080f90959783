//! Parameters of the detector of robots.

use bica::prelude::*;
use bica_vision::memory::MemoryTuning;
use bica_vision::robots::RobotTuning;

use crate::perception::Odometry;

/// Detection of other robots in an image.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct RobotDetection {
    /// Minimum height of a robot without a gap of green: its shoulders.
    #[param(default = 0.35, range = 0.05..=1.0, unit = "m", step = 0.01)]
    pub(super) min_height: f32,
    /// Maximum height of a robot.
    #[param(default = 0.6, range = 0.05..=1.5, unit = "m", step = 0.01)]
    pub(super) max_height: f32,
    /// Minimum width of a robot.
    #[param(default = 0.08, range = 0.01..=0.9, unit = "m", step = 0.01)]
    pub(super) min_width: f32,
    /// Maximum width of one robot; anything wider is two robots side by side.
    #[param(default = 0.38, range = 0.05..=0.9, unit = "m", step = 0.01)]
    pub(super) max_single_width: f32,
    /// Maximum gap between columns of one robot: the space between arm and leg.
    #[param(default = 0.18, range = 0.01..=0.5, unit = "m", step = 0.01)]
    pub(super) max_gap: f32,
    /// Minimum distance of a foot below the field boundary, as a share of the image height.
    #[param(default = 0.025, range = 0.0..=0.3, step = 0.005)]
    pub(super) boundary_margin: f32,
    /// Length of green that ends a robot, as a share of its minimum height: shoes and shadows contain some green.
    #[param(default = 0.03, range = 0.0..=0.5, step = 0.01)]
    pub(super) max_green: f32,
    /// Maximum share of goal and ball colours in a column of a robot.
    #[param(default = 0.3, range = 0.0..=1.0, step = 0.05)]
    pub(super) max_other_colours: f32,
    /// Minimum share of white in a column of a robot.
    #[param(default = 0.15, range = 0.0..=1.0, step = 0.05)]
    pub(super) min_white: f32,
    /// Minimum share of the team colour in the box around a robot.
    #[param(default = 0.01, range = 0.0..=0.2, step = 0.001)]
    pub(super) min_team_colour: f32,
}

impl RobotDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_height > self.max_height {
            Err("`min_height` must not be above `max_height`")
        } else if self.min_width > self.max_single_width {
            Err("`min_width` must not be above `max_single_width`")
        } else {
            Ok(())
        }
    }

    pub(super) const fn tuning(&self) -> RobotTuning {
        RobotTuning {
            min_height: self.min_height,
            max_height: self.max_height,
            min_width: self.min_width,
            max_single_width: self.max_single_width,
            max_gap: self.max_gap,
            boundary_margin: self.boundary_margin,
            max_green: self.max_green,
            max_other_colours: self.max_other_colours,
            min_white: self.min_white,
            min_team_colour: self.min_team_colour,
            ..RobotTuning::DEFAULT
        }
    }
}

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
        assert_eq!(RobotDetection::DEFAULT.tuning(), RobotTuning::DEFAULT);
        let tuning = RobotTracking::DEFAULT.tuning(&Odometry::new());
        assert_eq!(tuning, MemoryTuning { half_life: 4.0, ..MemoryTuning::DEFAULT });
    }

    #[test]
    fn sizes_are_ordered() {
        let robot = || RobotDetection::DEFAULT;
        assert!(RobotDetection { min_height: 0.61, ..robot() }.is_ordered().is_err());
        assert!(RobotDetection { min_width: 0.39, ..robot() }.is_ordered().is_err());
        assert!(RobotDetection { max_single_width: 0.07, ..robot() }.is_ordered().is_err());
        assert!(RobotDetection { max_single_width: 0.08, ..robot() }.is_ordered().is_ok());
    }
}
