//! What a picture shows, free of where it comes from.

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

/// What was recognised in an image, pixels: x right, y down, centre of the first pixel (0, 0).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    pub ball: Option<Ball>,
    pub goals: Vec<Goal>,
    /// The far end of the field, from left to right.
    pub field_boundary: Vec<Vec2>,
    pub lines: Vec<Line>,
    pub robots: Vec<Robot>,
    pub crossings: Vec<Crossing>,
    /// Points on the centre circle, one after the other.
    pub circle: Vec<Vec2>,
    /// The robot's own body.
    pub own: OwnBody,
}

/// What the robot believes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Beliefs {
    /// Where it stands on the field, m: odometry from where it truly started.
    pub robot: Pose2,
    /// The ball, m, in the robot's own frame.
    pub ball: Option<Vec2>,
    /// The middle of the goal that it attacks, m, in its own frame.
    pub goal: Option<Vec2>,
}

/// What is true, m, in the field's frame; only a referee knows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// The colour of the goal at positive x.
    pub attacks: GoalColour,
    pub robot: Pose2,
    pub ball: Vec2,
    /// The goalkeeper and other robots.
    pub others: Vec<Pose2>,
    /// The way of the ball so far.
    pub trail: Vec<Vec2>,
}

/// The tree at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeNow {
    pub graph: &'static Graph,
    /// For each component whether it is active.
    pub active: Vec<bool>,
    /// For each component the index of its state.
    pub states: Vec<Option<usize>>,
}

impl TreeNow {
    /// Whether a link is in use: its owner is active, and in the state that the link belongs to.
    pub fn uses(&self, node: usize, link: &Link) -> bool {
        self.active[node] && (link.state.is_none() || link.state == self.states[node])
    }

    /// The name of the state of an active state machine.
    pub fn state(&self, node: usize) -> Option<&'static str> {
        let state = self.states[node].filter(|_| self.active[node])?;
        self.graph.nodes[node].states.get(state).map(|state| state.name)
    }
}
