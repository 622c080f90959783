//! The lines on the carpet.

use bica::prelude::*;
use bica_vision::crossings::{self, Crossing, Crossings};
use bica_vision::frame::Frame;
use bica_vision::lines::{self, Line, Lines};

use super::{FieldEnd, RobotDetector};
use crate::input::{Colours, Eye};

/// How near lines must come to meet, as a part of the image's height: two scans of the search for lines.
const REACH: f32 = 0.05;

/// The white lines in the newest image, and where they cross. What is white on a robot is no line.
#[derive(Debug)]
pub struct FieldLines {
    lines: Lines,
    crossings: Crossings,
    image: u32,
}

#[component(hz = 30, budget_us = 300)]
impl FieldLines {
    /// Has seen no lines yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { lines: Lines::new(), crossings: Crossings::new(), image: 0 }
    }

    fn step(&mut self, eye: &Eye, colours: &Colours, end: &FieldEnd, robots: &RobotDetector) {
        if self.image == eye.count() {
            return;
        }
        self.image = eye.count();
        let Ok(frame) = Frame::from_image(&eye.image()) else { return };
        self.lines = lines::find(&frame, colours, end.line());
        self.lines.retain(|line| !robots.covers(line.from.midpoint(line.to)));
        self.crossings = crossings::among(&self.lines, REACH * f32::from(frame.height()));
    }

    /// The lines, px.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Where they cross, px.
    #[must_use]
    pub fn crossings(&self) -> &[Crossing] {
        &self.crossings
    }
}
