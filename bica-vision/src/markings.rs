//! Field markings: lines, their crossings, and the centre circle.

use bica_core::Params;
use bica_macros::Params;

use crate::centre_circle::{self, CentreCircle};
use crate::colour::Classify;
use crate::crossings::{self, Crossings};
use crate::frame::Frame;
use crate::lines::{self, Line, Lines};
use crate::projection::Camera;

/// Detection of markings among lines.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core)]
pub struct MarkingDetection {
    /// Maximum distance of a line.
    #[param(default = 4.5, range = 0.5..=10.0, unit = "m", step = 0.1)]
    pub max_line_distance: f32,
    /// Maximum distance of a crossing.
    #[param(default = 3.5, range = 0.5..=10.0, unit = "m", step = 0.1)]
    pub max_crossing_distance: f32,
    /// Minimum total length of the line segments on the centre circle.
    #[param(default = 0.5, range = 0.1..=4.0, unit = "m", step = 0.05)]
    pub min_circle_length: f32,
    /// Minimum share of the visible part of the centre circle that shows a line.
    #[param(default = 0.75, range = 0.0..=1.0, step = 0.05)]
    pub min_circle_share: f32,
}

/// Visible field markings: m, camera's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// Straight line segments, up to [`MarkingDetection::max_line_distance`] away.
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
        Self::of_tuned(frame, colours, camera, lines, &MarkingDetection::DEFAULT)
    }

    /// Finds the markings as [`of`](Self::of) does, with limits of the caller.
    #[must_use]
    pub fn of_tuned(
        frame: &Frame<'_>,
        colours: &impl Classify,
        camera: &Camera,
        lines: &[Line],
        tuning: &MarkingDetection,
    ) -> Self {
        let lines = lines::on_ground(lines, camera, tuning.max_line_distance);
        let circle = centre_circle::find(frame, colours, camera, &lines, tuning);
        let crossings = crossings::find(frame, colours, camera, &lines, circle.as_ref(), tuning.max_crossing_distance);
        Self { lines, crossings, circle }
    }
}
