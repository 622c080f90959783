//! Content of a picture, independent of its source.

use bica::graph::{Graph, Link};
use bica_field::GoalColour;
use bica_motion::pose::Pose2;
use bica_vision::ball::Ball;
use bica_vision::crossings::Crossing;
use bica_vision::goal::Goal;
use bica_vision::lines::Line;
use bica_vision::own_body::OwnBody;
use bica_vision::robots::Robot;
use glam::Vec2;

/// Detections in an image, px; the centre of the first pixel is (0, 0).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// The ball.
    pub ball: Option<Ball>,
    /// Goals.
    pub goals: Vec<Goal>,
    /// Field boundary, from left to right.
    pub field_boundary: Vec<Vec2>,
    /// White lines.
    pub lines: Vec<Line>,
    /// Other robots.
    pub robots: Vec<Robot>,
    /// Crossings of lines.
    pub crossings: Vec<Crossing>,
    /// Points on the centre circle, in order.
    pub circle: Vec<Vec2>,
    /// The robot's own body.
    pub own: OwnBody,
}

/// Estimates of the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimates {
    /// Pose on the field, m: odometry from the true start.
    pub robot: Pose2,
    /// Ball in the robot's frame, m.
    pub ball: Option<Vec2>,
    /// Centre of the attacked goal in the robot's frame, m.
    pub goal: Option<Vec2>,
}

/// True state of a game in the field frame, m.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundTruth {
    /// Colour of the goal at positive x, which the robot attacks.
    pub attacks: GoalColour,
    /// Pose of the robot.
    pub robot: Pose2,
    /// Position of the ball.
    pub ball: Vec2,
    /// Poses of the goalkeeper and other robots.
    pub others: Vec<Pose2>,
    /// Path of the ball so far.
    pub trail: Vec<Vec2>,
}

/// State of an activation tree after a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeState {
    /// The tree.
    pub graph: &'static Graph,
    /// Whether each component is active.
    pub active: Vec<bool>,
    /// State of each state machine.
    pub states: Vec<Option<usize>>,
}

impl TreeState {
    /// Returns whether a link is in use: its owner is active and in the state that the link belongs to.
    #[must_use]
    pub fn uses(&self, node: usize, link: &Link) -> bool {
        self.active[node] && (link.state.is_none() || link.state == self.states[node])
    }

    /// Returns the name of the state of an active state machine.
    #[must_use]
    pub fn state(&self, node: usize) -> Option<&'static str> {
        let state = self.states[node].filter(|_| self.active[node])?;
        self.graph.nodes[node].states.get(state).map(|state| state.name)
    }
}
