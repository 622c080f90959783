//! The other robots.

use bica::prelude::*;
use bica_vision::frame::Frame;
use bica_vision::memory::multi_target::MultiTargetMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use bica_vision::projection::Camera;
use bica_vision::robots::{self, Robot, Robots};
use bica_vision::uncertainty::{self, Errors};
use glam::Vec2;

use super::ride::Ride;
use super::{CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{Colours, Eye};

/// How many are remembered.
const REMEMBERED: usize = 4;
/// Time without a sighting in which the belief in a robot's place halves, s: robots walk.
const HALF_LIFE: f32 = 4.0;
/// How much a sighting is believed.
const CONFIDENCE: f32 = 0.8;
/// How far a robot's middle may be from the edge of its feet, m.
const WIDTH: f32 = 0.1;
/// A robot farther away than this may be there and not be seen, m.
const VISIBLE: f32 = 2.0;

/// The other robots in the newest image, and where those are that were seen before.
#[derive(Debug)]
pub struct RobotDetector {
    robots: Robots,
    memory: MultiTargetMemory<REMEMBERED>,
    ride: Ride,
}

#[component(hz = 30, budget_us = 300)]
impl RobotDetector {
    /// Has seen no robots yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { robots: Robots::new(), memory: MultiTargetMemory::new(HALF_LIFE), ride: Ride::new() }
    }

    fn step(
        &mut self,
        time: &Time,
        eye: &Eye,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.memory.advance(self.ride.motion(odometry), time.dt());
        if !self.ride.sees_anew(eye) {
            return;
        }
        if let Ok(frame) = Frame::from_image(&eye.image()) {
            self.robots = robots::find(&frame, colours, end.line(), pose.camera());
            self.robots.retain(|robot| !own.body().covers(robot.base()));
            if let Some(camera) = pose.camera() {
                self.note(camera, own, Vec2::new(frame.width().into(), frame.height().into()));
            }
        }
    }

    fn note(&mut self, camera: &Camera, own: &OwnBody, size: Vec2) {
        for robot in &self.robots {
            let spread = uncertainty::of_ground(camera, robot.base(), 0.0, &Errors::NAO);
            if let Some((at, spread)) = robot.ground(camera).zip(spread) {
                self.memory.see(at, &(spread + uncertainty::round(WIDTH)), CONFIDENCE);
            }
        }
        self.memory.miss(|place| visibility::is_in_view(camera, size, own.body(), place, WIDTH, VISIBLE));
    }

    /// Where robots are believed to be, m, in the frame on the ground between the feet.
    pub fn places(&self) -> impl Iterator<Item = PositionEstimate> + '_ {
        self.memory.places()
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
