//! Everything at once: the detectors in the order in which one needs the other.
//!
//! A caller who wants less calls the detectors alone; what each costs stands at its module.

use glam::Vec2;

use crate::ball::{Ball, BallFinder};
use crate::colour::Classify;
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::goal::{GoalFinder, Goals};
use crate::lines::{self, Lines};
use crate::markings::Markings;
use crate::own_body::OwnBody;
use crate::projection::Camera;
use crate::robots::{self, Robots};

/// All detectors, with memory for `B` runs of the ball's colour and `G` runs of the goals' colours.
///
/// 512 of each are plenty.
#[derive(Clone, Debug)]
pub struct Pipeline<const B: usize, const G: usize> {
    balls: BallFinder<B>,
    goals: GoalFinder<G>,
}

/// What is seen in a frame.
#[derive(Clone, Debug, Default)]
pub struct Detections {
    /// The line at which the field ends.
    pub end: FieldBoundary,
    /// The ball.
    pub ball: Option<Ball>,
    /// Both goals.
    pub goals: Goals,
    /// Other robots; none without a camera's pose, as then a line that runs away looks as upright as a robot.
    pub robots: Robots,
    /// White lines, px; not those on a robot.
    pub lines: Lines,
    /// What these are on the ground, with their crossings and the centre circle; nothing without a camera's pose.
    pub markings: Markings,
}

impl<const B: usize, const G: usize> Pipeline<B, G> {
    /// For balls of a radius, m.
    #[must_use]
    pub const fn new(radius: f32) -> Self {
        Self { balls: BallFinder::new(radius), goals: GoalFinder::new() }
    }

    /// Looks for everything in a frame; with `camera`, what does not fit its pose is refused.
    pub fn look(&mut self, frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Detections {
        self.detect_with_body(frame, colours, camera, &OwnBody::NONE)
    }

    /// As [`look`](Self::look); a ball or a line on the robot's own body is none.
    pub fn detect_with_body(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        camera: Option<&Camera>,
        own: &OwnBody,
    ) -> Detections {
        let end = FieldBoundary::find_with(frame, colours, camera);
        let ball = self.balls.find_with_body(frame, colours, &end, camera, own);
        let goals = self.goals.find(frame, colours, &end, camera);
        let robots = camera.map(|camera| robots::find(frame, colours, &end, Some(camera))).unwrap_or_default();
        let mut lines = lines::find(frame, colours, &end, camera);
        let on_robot = |at: Vec2| own.covers(at) || robots.iter().any(|robot| robot.covers(at));
        lines.retain(|line| !on_robot(line.from.midpoint(line.to)));
        let markings = camera.map(|camera| Markings::of(frame, colours, camera, &lines)).unwrap_or_default();
        Detections { end, ball, goals, robots, lines, markings }
    }
}
