//! The field boundary in the image.

use bica::prelude::*;
use bica_vision::field_boundary::FieldBoundary as Line;
use bica_vision::frame::Frame;

use super::ego_motion::LastImage;
use crate::input::{CameraInput, Colours};

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

    fn step(&mut self, input: &CameraInput, colours: &Colours) {
        if self.image.take_new(input) {
            self.line = Frame::from_image(&input.image()).map_or(Line::NONE, |frame| Line::find(&frame, colours));
        }
    }

    /// The boundary.
    #[must_use]
    pub const fn line(&self) -> &Line {
        &self.line
    }
}
