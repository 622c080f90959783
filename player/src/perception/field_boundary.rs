//! Where the field ends in the image.

use bica::prelude::*;
use bica_vision::field_boundary::FieldBoundary as Line;
use bica_vision::frame::Frame;

use crate::input::{Colours, Eye};

/// The line at which the carpet ends in the newest image. What is above it is not on the field.
#[derive(Debug)]
pub struct FieldBoundary {
    line: Line,
    image: u32,
}

#[component(hz = 30, budget_us = 300)]
impl FieldBoundary {
    /// Has seen no field yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { line: Line::NONE, image: 0 }
    }

    fn step(&mut self, eye: &Eye, colours: &Colours) {
        if self.image != eye.count() {
            self.image = eye.count();
            self.line = Frame::from_image(&eye.image()).map_or(Line::NONE, |frame| Line::find(&frame, colours));
        }
    }

    /// The line.
    #[must_use]
    pub const fn line(&self) -> &Line {
        &self.line
    }
}
