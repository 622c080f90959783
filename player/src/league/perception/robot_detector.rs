//! Other robots.

use bica::prelude::*;
use bica::visual::{List, Point2};
use bica_vision::memory::PositionEstimate;
use bica_vision::uncertainty;
use glam::Vec2;
use heapless::Vec;

use super::CameraPose;
use crate::league::input::CameraInput;
use crate::league::senses::Object;
use crate::perception::Odometry;
use crate::perception::ego_motion::EgoMotion;
use crate::shapes;

/// Maximum number of robots.
const ROBOTS: usize = 4;
/// Standard deviation of the position of a robot of which a foot is seen, m.
const FOOT_ERROR: f32 = 0.15;

/// The feet of other robots in the newest view.
#[derive(Debug)]
pub struct RobotDetector {
    feet: Vec<Vec2, ROBOTS>,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 10)]
impl RobotDetector {
    /// Creates the component without robots.
    #[must_use]
    pub const fn new() -> Self {
        Self { feet: Vec::new(), ego_motion: EgoMotion::new() }
    }

    fn step(&mut self, time: &Time, input: &CameraInput, camera: &CameraPose, odometry: &Odometry) {
        let feet = &mut self.feet;
        let advance = |motion: bica_motion::pose::Pose2, seconds: f32| {
            feet.retain(|_| seconds.is_finite());
            for foot in feet {
                *foot = motion.locate(*foot);
            }
        };
        if self.ego_motion.begin_run(time, odometry, input, advance) {
            let seen = input.sights().iter().filter(|sight| sight.object == Object::Robot);
            self.feet = seen.filter_map(|sight| camera.ground(sight.at, 0.0)).take(ROBOTS).collect();
        }
    }

    /// Counts a cycle since the last run and the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// The position of one of the robots, by its index from 0, m, in the ground frame between the feet of this robot; `None` after the
    /// last one, and if the motion of this robot is not known.
    #[must_use]
    pub fn place(&self, index: usize) -> Option<PositionEstimate> {
        let position = *self.feet.get(index).filter(|_| self.ego_motion.is_fresh())?;
        Some(PositionEstimate { position, covariance: uncertainty::round(FOOT_ERROR) })
    }

    /// The positions.
    #[output(unit = "m", frame = "robot")]
    fn robot_positions(&self) -> List<Point2, ROBOTS> {
        self.feet.iter().copied().map(shapes::point).collect()
    }
}
