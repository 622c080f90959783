//! The other robots.

use bica::prelude::*;
use bica_vision::frame::Frame;
use bica_vision::robots::{self, Robot, Robots};
use glam::Vec2;

use super::{CameraPose, FieldEnd};
use crate::input::{Colours, Eye};

/// The other robots in the newest image.
#[derive(Debug)]
pub struct RobotDetector {
    robots: Robots,
    image: u32,
}

#[component(hz = 30, budget_us = 200)]
impl RobotDetector {
    /// Has seen no robots yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { robots: Robots::new(), image: 0 }
    }

    fn step(&mut self, eye: &Eye, colours: &Colours, end: &FieldEnd, pose: &CameraPose) {
        if self.image == eye.count() {
            return;
        }
        self.image = eye.count();
        if let Ok(frame) = Frame::from_image(&eye.image()) {
            self.robots = robots::find(&frame, colours, end.line(), pose.camera());
        }
    }

    /// The robots, px.
    #[must_use]
    pub fn robots(&self) -> &[Robot] {
        &self.robots
    }

    /// Whether a pixel shows a robot.
    #[must_use]
    pub fn covers(&self, pixel: Vec2) -> bool {
        self.robots.iter().any(|robot| robot.covers(pixel))
    }
}
