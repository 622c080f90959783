//! All detectors, in the order of their dependencies.
//!
//! A caller that needs fewer objects calls the detectors directly; each module states its cost.

use bica_core::Params;
use glam::Vec2;

use crate::ball::{Ball, BallDetection, BallFinder};
use crate::colour::Classify;
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::goal::{GoalFinder, Goals};
use crate::lines::{self, Lines};
use crate::markings::Markings;
use crate::own_body::OwnBody;
use crate::projection::Camera;
use crate::robots::{self, Robots};
use crate::uncertainty::Errors;

/// All detectors, with memory for `B` runs of the ball's colour and `G` runs of the goals' colours.
///
/// 512 of each are enough.
#[derive(Clone, Debug)]
pub struct Pipeline<const B: usize, const G: usize> {
    balls: BallFinder<B>,
    goals: GoalFinder<G>,
}

/// Objects detected in a frame.
#[derive(Clone, Debug, Default)]
pub struct Detections {
    /// Field boundary.
    pub boundary: FieldBoundary,
    /// Ball.
    pub ball: Option<Ball>,
    /// Goals.
    pub goals: Goals,
    /// Other robots; empty without a camera pose, because a receding line is then as upright as a robot.
    pub robots: Robots,
    /// White lines, px, except those on a robot.
    pub lines: Lines,
    /// Lines on the ground, with their crossings and the centre circle; empty without a camera pose.
    pub markings: Markings,
}

impl<const B: usize, const G: usize> Pipeline<B, G> {
    /// Creates detectors for balls of a radius in metres.
    #[must_use]
    pub const fn new(radius: f32) -> Self {
        Self { balls: BallFinder::new(radius), goals: GoalFinder::new() }
    }

    /// Detects all objects in a frame. With `camera`, objects that contradict its pose are rejected.
    pub fn detect(&mut self, frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Detections {
        self.detect_with_body(frame, colours, camera, &OwnBody::NONE)
    }

    /// Detects all objects as [`detect`](Self::detect) does, and ignores balls and lines on the robot's own body.
    pub fn detect_with_body(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        camera: Option<&Camera>,
        own: &OwnBody,
    ) -> Detections {
        let boundary = FieldBoundary::find_with(frame, colours, camera);
        let with_errors = camera.map(|camera| (camera, &Errors::NAO));
        let ball = self.balls.find_tuned(frame, colours, &boundary, with_errors, own, &BallDetection::DEFAULT);
        let goals = self.goals.find(frame, colours, &boundary, camera);
        let robots = camera.map(|camera| robots::find(frame, colours, &boundary, Some(camera))).unwrap_or_default();
        let mut lines = lines::find(frame, colours, &boundary, camera);
        let on_robot = |at: Vec2| own.covers(at) || robots.iter().any(|robot| robot.covers(at));
        lines.retain(|line| !on_robot(line.from.midpoint(line.to)));
        let markings = camera.map(|camera| Markings::of(frame, colours, camera, &lines)).unwrap_or_default();
        Detections { boundary, ball, goals, robots, lines, markings }
    }
}
