//! All that is painted on the carpet: lines, their crossings, the centre circle.

use crate::centre_circle::{self, CentreCircle};
use crate::colour::Classify;
use crate::crossings::{self, Crossings};
use crate::frame::Frame;
use crate::lines::{self, Line, Lines};
use crate::projection::Camera;

/// What is painted on the carpet, as far as it is seen: m, in the camera's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// Straight pieces of lines, up to [`lines::FARTHEST`] away.
    pub lines: Lines,
    /// Where they cross.
    pub crossings: Crossings,
    /// The centre circle.
    pub circle: Option<CentreCircle>,
}

impl Markings {
    /// None.
    pub const NONE: Self = Self { lines: Lines::new(), crossings: Crossings::new(), circle: None };

    /// What the lines of an image, px, are on the ground. Cost: 8 µs, up to 50 µs where there are many.
    #[must_use]
    pub fn of(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, lines: &[Line]) -> Self {
        let lines = lines::on_ground(lines, camera, lines::FARTHEST);
        let circle = centre_circle::find(frame, colours, camera, &lines);
        let crossings = crossings::find(frame, colours, camera, &lines, circle.as_ref());
        Self { lines, crossings, circle }
    }
}
