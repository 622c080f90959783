//! The field markings.

use bica::prelude::*;
use bica::visual::{List, Point2, Segment};
use bica_vision::frame::Frame;
use bica_vision::lines::{self, Line, LineDetection};
use bica_vision::markings::{MarkingDetection, Markings};
use glam::Vec2;

use super::ego_motion::LastImage;
use super::{CameraPose, FieldBoundary, OwnBody, RobotDetector};
use crate::input::{CameraInput, Colours};
use crate::shapes;

/// Maximum number of published line segments.
const DRAWN: usize = 16;

/// Field lines in the newest image, their crossings and the centre circle. White pixels on robots, including this one,
/// are excluded.
#[derive(Debug)]
pub struct FieldLines {
    markings: Markings,
    image: LastImage,
}

#[component(hz = 30, budget_us = 300)]
impl FieldLines {
    /// Creates the component without markings.
    #[must_use]
    pub const fn new() -> Self {
        Self { markings: Markings::NONE, image: LastImage::new() }
    }

    fn step(
        &mut self,
        line: &Tuned<LineDetection>,
        marking: &Tuned<MarkingDetection>,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        robots: &RobotDetector,
        own: &OwnBody,
        pose: &CameraPose,
    ) {
        if !self.image.take_new(input) {
            return;
        }
        self.markings = Markings::NONE;
        let Ok(frame) = Frame::from_image(&input.image()) else { return };
        let Some(camera) = pose.camera() else { return };
        let mut lines = lines::find_tuned(&frame, colours.table(), end.line(), Some(camera), line);
        let on_robot = |at: Vec2| own.body().covers(at) || robots.covers(at);
        lines.retain(|line| !on_robot(line.from.midpoint(line.to)));
        self.markings = Markings::of_tuned(&frame, colours.table(), camera, &lines, marking);
    }

    /// Number of line segments.
    #[output]
    fn line_count(&self) -> u32 {
        self.markings.lines.len() as u32
    }

    /// Total length of the line segments on the ground.
    #[output(unit = "m")]
    fn line_length(&self) -> f32 {
        self.markings.lines.iter().map(Line::length).sum()
    }

    /// Number of crossings.
    #[output]
    fn crossing_count(&self) -> u32 {
        self.markings.crossings.len() as u32
    }

    /// The first line segments on the ground.
    #[output(unit = "m", frame = "robot")]
    fn lines(&self) -> List<Segment, DRAWN> {
        let segment = |line: &Line| Segment { start: shapes::point(line.from), end: shapes::point(line.to) };
        self.markings.lines.iter().map(segment).collect()
    }

    /// Centre of the centre circle.
    #[output(unit = "m", frame = "robot")]
    fn circle_centre(&self) -> Option<Point2> {
        self.markings.circle.map(|circle| shapes::point(circle.centre))
    }

    /// Counts a cycle since the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.image.age.pass_cycle();
    }

    /// The markings, m, in the ground frame between the feet; none if there was no image for half a second.
    #[must_use]
    pub const fn markings(&self) -> &Markings {
        const NONE: &Markings = &Markings::NONE;
        if self.image.age.is_fresh() { &self.markings } else { NONE }
    }
}
