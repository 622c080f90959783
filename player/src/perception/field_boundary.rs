//! The field boundary in the image.

use bica::prelude::*;
use bica::visual::ImagePolyline;
use bica_vision::field_boundary::{BoundaryDetection, COLUMNS, FieldBoundary as Line};
use bica_vision::frame::Frame;
use bica_vision::projection::Camera;
use glam::Vec2;

use super::ego_motion::LastImage;
use crate::input::{CameraInput, Colours};
use crate::shapes;

/// The field boundary in the newest image (the paper's "end of field"). Pixels above it do not show the field.
#[derive(Debug)]
pub struct FieldBoundary {
    line: Line,
    image: LastImage,
}

#[component(hz = 30, budget_us = 300)]
impl FieldBoundary {
    /// Creates the component without a boundary.
    #[must_use]
    pub const fn new() -> Self {
        Self { line: Line::NONE, image: LastImage::new() }
    }

    fn step(&mut self, tuned: &Tuned<BoundaryDetection>, input: &CameraInput, colours: &Colours) {
        if self.image.take_new(input) {
            let find = |frame: Frame<'_>| Line::find_tuned(&frame, colours.table(), None, tuned);
            self.line = Frame::from_image(&input.image()).map_or(Line::NONE, find);
        }
    }

    /// Counts a cycle since the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.image.age.pass_cycle();
    }

    /// Highest row of the boundary; `None` if no field is in view.
    #[output(unit = "px")]
    fn top(&self) -> Option<f32> {
        self.line.top()
    }

    /// The boundary from its left end to its right one; without points if no field is in view.
    #[output(unit = "px", frame = "camera")]
    fn corners(&self) -> ImagePolyline<COLUMNS> {
        ImagePolyline { points: self.line.corners().iter().copied().map(shapes::pixel).collect() }
    }

    /// Whether the newest image, which `camera` took, shows the field at a position in the ground frame between the feet, m; see
    /// [`Line::shows_field`]. False if there was no image for half a second.
    #[must_use]
    pub fn is_on_field(&self, camera: &Camera, at: Vec2) -> bool {
        self.image.age.is_fresh() && self.line.shows_field(camera, at)
    }

    /// The boundary.
    #[must_use]
    pub const fn line(&self) -> &Line {
        &self.line
    }
}
