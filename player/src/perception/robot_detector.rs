//! Other robots.

mod params;

use bica::prelude::*;
use bica::visual::{List, Point2};
use bica_vision::frame::Frame;
use bica_vision::memory::multi_target::MultiTargetMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use bica_vision::robots::{self, Robot, RobotDetection, Robots};
use bica_vision::uncertainty;
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{CameraInput, Colours};
use crate::shapes;

pub use params::RobotTracking;

/// Maximum number of remembered robots.
const REMEMBERED: usize = 4;

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
        let memory = MultiTargetMemory::new(RobotTracking::DEFAULT.half_life);
        Self { robots: Robots::new(), memory, ego_motion: EgoMotion::new() }
    }

    fn step(
        &mut self,
        detection: &Tuned<RobotDetection>,
        tracking: &Tuned<RobotTracking>,
        time: &Time,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.memory.set_tuning(&tracking.tuning(odometry));
        let advance = |motion, seconds| self.memory.advance(motion, seconds);
        if !self.ego_motion.begin_run(time, odometry, input, advance) {
            return;
        }
        if let Ok(frame) = Frame::from_image(&input.image()) {
            self.robots = robots::find_tuned(&frame, colours.table(), end.line(), pose.camera(), detection);
            self.robots.retain(|robot| !own.body().covers(robot.base()));
            self.remember(tracking, pose, own, Vec2::new(frame.width().into(), frame.height().into()));
        }
    }

    fn remember(&mut self, tracking: &RobotTracking, pose: &CameraPose, own: &OwnBody, size: Vec2) {
        let Some(camera) = pose.camera() else { return };
        let (width, far) = (tracking.width_error, tracking.visible_distance);
        for robot in &self.robots {
            let spread = uncertainty::of_ground(camera, robot.base(), 0.0, pose.errors());
            if let Some((at, spread)) = robot.ground(camera).zip(spread) {
                self.memory.see(at, &(spread + uncertainty::round(width)), tracking.sighting_confidence);
            }
        }
        self.memory.miss(|place| visibility::is_in_view(camera, size, own.body(), place, width, far));
    }

    /// Counts a cycle since the last run and the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// The remembered positions, m, in the ground frame between the feet; none if the motion of this robot is not known.
    pub fn places(&self) -> impl Iterator<Item = PositionEstimate> + '_ {
        self.memory.places().filter(|_| self.ego_motion.is_fresh())
    }

    /// The position of one of the remembered robots, by its index from 0; `None` after the last one.
    #[must_use]
    pub fn place(&self, index: usize) -> Option<PositionEstimate> {
        self.places().nth(index)
    }

    /// Positions of the remembered robots.
    #[output(unit = "m", frame = "robot")]
    fn robot_positions(&self) -> List<Point2, REMEMBERED> {
        self.places().map(|place| shapes::point(place.position)).collect()
    }

    /// Number of robots in the newest image.
    #[output]
    fn robots_in_image(&self) -> u32 {
        self.robots.len() as u32
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
