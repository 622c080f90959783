//! What is painted on the carpet.

use bica::prelude::*;
use bica_vision::frame::Frame;
use bica_vision::lines;
use bica_vision::markings::Markings;
use glam::Vec2;

use super::{CameraPose, FieldBoundary, OwnBody, RobotDetector};
use crate::input::{Colours, Eye};

/// The white lines in the newest image, where they cross, and the centre circle. What is white on a robot, or on this one, is no line.
#[derive(Debug)]
pub struct FieldLines {
    markings: Markings,
    image: u32,
}

#[component(hz = 30, budget_us = 300)]
impl FieldLines {
    /// Has seen no lines yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { markings: Markings::NONE, image: 0 }
    }

    fn step(
        &mut self,
        eye: &Eye,
        colours: &Colours,
        end: &FieldBoundary,
        robots: &RobotDetector,
        own: &OwnBody,
        pose: &CameraPose,
    ) {
        if self.image == eye.count() {
            return;
        }
        self.image = eye.count();
        self.markings = Markings::NONE;
        let Ok(frame) = Frame::from_image(&eye.image()) else { return };
        let Some(camera) = pose.camera() else { return };
        let mut lines = lines::find(&frame, colours, end.line(), Some(camera));
        let on_robot = |at: Vec2| own.body().covers(at) || robots.covers(at);
        lines.retain(|line| !on_robot(line.from.midpoint(line.to)));
        self.markings = Markings::of(&frame, colours, camera, &lines);
    }

    /// What is painted on the carpet, m, in the frame on the ground between the feet.
    #[must_use]
    pub const fn markings(&self) -> &Markings {
        &self.markings
    }
}
