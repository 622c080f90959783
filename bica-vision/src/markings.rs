//! Field markings: lines, their crossings, and the centre circle.

use crate::centre_circle::{self, CentreCircle};
use crate::colour::Classify;
use crate::crossings::{self, Crossings};
use crate::frame::Frame;
use crate::lines::{self, Line, Lines};
use crate::projection::Camera;

/// Visible field markings: m, camera's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// Straight line segments, up to [`lines::FARTHEST`] away.
    pub lines: Lines,
    /// Line crossings.
    pub crossings: Crossings,
    /// Centre circle.
    pub circle: Option<CentreCircle>,
}

impl Markings {
    /// No markings.
    pub const NONE: Self = Self { lines: Lines::new(), crossings: Crossings::new(), circle: None };

    /// Projects the lines of an image, px, to the ground and finds the other markings. Cost: 8 µs, up to 50 µs with
    /// many lines.
    #[must_use]
    pub fn of(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, lines: &[Line]) -> Self {
        let lines = lines::on_ground(lines, camera, lines::FARTHEST);
        let circle = centre_circle::find(frame, colours, camera, &lines);
        let crossings = crossings::find(frame, colours, camera, &lines, circle.as_ref());
        Self { lines, crossings, circle }
    }
}
