//! Field markings: lines, their crossings, and the centre circle.

use crate::centre_circle::{self, CentreCircle};
use crate::colour::Classify;
use crate::crossings::{self, Crossings};
use crate::frame::Frame;
use crate::lines::{self, Line, Lines};
use crate::projection::Camera;

/// Limits of the field markings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MarkingTuning {
    /// Maximum distance of a line from the robot, m.
    pub max_line_distance: f32,
    /// Maximum distance of a crossing from the robot, m.
    pub max_crossing_distance: f32,
    /// Minimum total length of the segments on the centre circle, m.
    pub min_circle_length: f32,
    /// Minimum share of the visible part of the centre circle that shows a line, 0 to 1.
    pub min_circle_share: f32,
}

impl MarkingTuning {
    /// The default limits.
    pub const DEFAULT: Self =
        Self { max_line_distance: 4.5, max_crossing_distance: 3.5, min_circle_length: 0.5, min_circle_share: 0.75 };
}

/// Visible field markings: m, camera's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// Straight line segments, up to [`MarkingTuning::max_line_distance`] away.
    pub lines: Lines,
    /// Line crossings.
    pub crossings: Crossings,
    /// Centre circle.
    pub circle: Option<CentreCircle>,
}

impl Markings {
    /// No markings.
    pub const NONE: Self = Self { lines: Lines::new(), crossings: Crossings::new(), circle: None };

    /// Projects the lines of an image, px, to the ground and finds the other markings. Cost: 8 µs, up to 50 µs with many lines.
    #[must_use]
    pub fn of(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, lines: &[Line]) -> Self {
        Self::of_tuned(frame, colours, camera, lines, &MarkingTuning::DEFAULT)
    }

    /// Finds the markings as [`of`](Self::of) does, with limits of the caller.
    #[must_use]
    pub fn of_tuned(
        frame: &Frame<'_>,
        colours: &impl Classify,
        camera: &Camera,
        lines: &[Line],
        tuning: &MarkingTuning,
    ) -> Self {
        let lines = lines::on_ground(lines, camera, tuning.max_line_distance);
        let circle = centre_circle::find(frame, colours, camera, &lines, tuning);
        let crossings = crossings::find(frame, colours, camera, &lines, circle.as_ref(), tuning.max_crossing_distance);
        Self { lines, crossings, circle }
    }
}
