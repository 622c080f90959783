//! Other robots.

use bica::prelude::*;
use bica_vision::frame::Frame;
use bica_vision::memory::multi_target::MultiTargetMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use bica_vision::projection::Camera;
use bica_vision::robots::{self, Robot, Robots};
use bica_vision::uncertainty::{self, Errors};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{CameraInput, Colours};

/// Maximum number of remembered robots.
const REMEMBERED: usize = 4;
/// Half-life of the confidence in a robot that is not seen, s.
const HALF_LIFE: f32 = 4.0;
/// Confidence of a sighting, 0 to 1.
const CONFIDENCE: f32 = 0.8;
/// Standard deviation from the edge of a robot's feet to its middle, m.
const WIDTH: f32 = 0.1;
/// Distance up to which a robot in view is always detected, m.
const VISIBLE: f32 = 2.0;

/// The other robots in the newest image, and the remembered positions of those that are out of view.
#[derive(Debug)]
pub struct RobotDetector {
    robots: Robots,
    memory: MultiTargetMemory<REMEMBERED>,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 300)]
impl RobotDetector {
    /// Creates the component without robots.
    #[must_use]
    pub const fn new() -> Self {
        Self { robots: Robots::new(), memory: MultiTargetMemory::new(HALF_LIFE), ego_motion: EgoMotion::new() }
    }

    fn step(
        &mut self,
        time: &Time,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        let advance = |motion| self.memory.advance(motion, time.dt());
        if !self.ego_motion.begin_run(odometry, input, advance) {
            return;
        }
        if let Ok(frame) = Frame::from_image(&input.image()) {
            self.robots = robots::find(&frame, colours, end.line(), pose.camera());
            self.robots.retain(|robot| !own.body().covers(robot.base()));
            if let Some(camera) = pose.camera() {
                self.remember(camera, own, Vec2::new(frame.width().into(), frame.height().into()));
            }
        }
    }

    fn remember(&mut self, camera: &Camera, own: &OwnBody, size: Vec2) {
        for robot in &self.robots {
            let spread = uncertainty::of_ground(camera, robot.base(), 0.0, &Errors::NAO);
            if let Some((at, spread)) = robot.ground(camera).zip(spread) {
                self.memory.see(at, &(spread + uncertainty::round(WIDTH)), CONFIDENCE);
            }
        }
        self.memory.miss(|place| visibility::is_in_view(camera, size, own.body(), place, WIDTH, VISIBLE));
    }

    /// The remembered positions, m, in the ground frame between the feet.
    pub fn places(&self) -> impl Iterator<Item = PositionEstimate> + '_ {
        self.memory.places()
    }

    /// The robots in the newest image, px.
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
