//! Parameters of the detector of field markings.

use bica::prelude::*;
use bica_vision::lines::LineTuning;
use bica_vision::markings::MarkingTuning;

/// Detection of lines in an image.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct LineDetection {
    /// Constant part of the minimum luma step from carpet to line; a sixth of the carpet's luma is added.
    #[param(default = 12, range = 1..=100)]
    pub(super) min_rise: u32,
    /// Minimum luma step of a line thinner than a pixel.
    #[param(default = 30, range = 1..=200)]
    pub(super) min_thin_rise: u32,
    /// Minimum width of a line on the ground.
    #[param(default = 0.02, range = 0.0..=0.1, unit = "m", step = 0.005)]
    pub(super) min_line_width: f32,
    /// Maximum width of a line on the ground; anything wider is a robot's limb.
    #[param(default = 0.085, range = 0.02..=0.3, unit = "m", step = 0.005)]
    pub(super) max_line_width: f32,
}

impl LineDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_line_width < self.max_line_width {
            Ok(())
        } else {
            Err("`min_line_width` must be below `max_line_width`")
        }
    }

    pub(super) const fn tuning(&self) -> LineTuning {
        LineTuning {
            min_rise: self.min_rise as i16,
            min_thin_rise: self.min_thin_rise as i32,
            min_width: self.min_line_width,
            max_width: self.max_line_width,
        }
    }
}

/// Detection of markings among lines.
#[derive(Params)]
pub struct MarkingDetection {
    /// Maximum distance of a line.
    #[param(default = 4.5, range = 0.5..=10.0, unit = "m", step = 0.1)]
    pub(super) max_line_distance: f32,
    /// Maximum distance of a crossing.
    #[param(default = 3.5, range = 0.5..=10.0, unit = "m", step = 0.1)]
    pub(super) max_crossing_distance: f32,
    /// Minimum total length of the line segments on the centre circle.
    #[param(default = 0.5, range = 0.1..=4.0, unit = "m", step = 0.05)]
    pub(super) min_circle_length: f32,
    /// Minimum share of the visible part of the centre circle that shows a line.
    #[param(default = 0.75, range = 0.0..=1.0, step = 0.05)]
    pub(super) min_circle_share: f32,
}

impl MarkingDetection {
    pub(super) const fn tuning(&self) -> MarkingTuning {
        MarkingTuning {
            max_line_distance: self.max_line_distance,
            max_crossing_distance: self.max_crossing_distance,
            min_circle_length: self.min_circle_length,
            min_circle_share: self.min_circle_share,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_values_are_those_of_detector() {
        assert_eq!(LineDetection::DEFAULT.tuning(), LineTuning::DEFAULT);
        assert_eq!(MarkingDetection::DEFAULT.tuning(), MarkingTuning::DEFAULT);
    }

    #[test]
    fn a_line_has_a_width() {
        assert!(LineDetection { min_line_width: 0.085, ..LineDetection::DEFAULT }.is_ordered().is_err());
    }
}
