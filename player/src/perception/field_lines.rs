//! The field markings.

use bica::prelude::*;
use bica_vision::frame::Frame;
use bica_vision::lines;
use bica_vision::markings::Markings;
use glam::Vec2;

use super::ego_motion::LastImage;
use super::{CameraPose, FieldBoundary, OwnBody, RobotDetector};
use crate::input::{CameraInput, Colours};

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
        let mut lines = lines::find(&frame, colours, end.line(), Some(camera));
        let on_robot = |at: Vec2| own.body().covers(at) || robots.covers(at);
        lines.retain(|line| !on_robot(line.from.midpoint(line.to)));
        self.markings = Markings::of(&frame, colours, camera, &lines);
    }

    /// The markings, m, in the ground frame between the feet.
    #[must_use]
    pub const fn markings(&self) -> &Markings {
        &self.markings
    }
}
