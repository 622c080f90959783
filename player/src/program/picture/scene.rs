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
pub(crate) struct Marks {
    pub(crate) ball: Option<Ball>,
    pub(crate) goals: Vec<Goal>,
    /// The far end of the field, from left to right.
    pub(crate) field_end: Vec<Vec2>,
    pub(crate) lines: Vec<Line>,
    pub(crate) robots: Vec<Robot>,
    pub(crate) crossings: Vec<Crossing>,
    /// Points on the centre circle, one after the other.
    pub(crate) circle: Vec<Vec2>,
    /// The robot's own body.
    pub(crate) own: OwnBody,
}

/// What the robot believes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Beliefs {
    /// Where it stands on the field, m: odometry from where it truly started.
    pub(crate) robot: Pose2,
    /// The ball, m, in the robot's own frame.
    pub(crate) ball: Option<Vec2>,
    /// The middle of the goal that it attacks, m, in its own frame.
    pub(crate) goal: Option<Vec2>,
}

/// What is true, m, in the field's frame; only a referee knows it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Truth {
    /// The colour of the goal at positive x.
    pub(crate) attacks: GoalColour,
    pub(crate) robot: Pose2,
    pub(crate) ball: Vec2,
    /// The goalkeeper and other robots.
    pub(crate) others: Vec<Pose2>,
    /// The way of the ball so far.
    pub(crate) trail: Vec<Vec2>,
}

/// The tree at one moment.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TreeNow {
    pub(crate) graph: &'static Graph,
    /// For each component whether it is active.
    pub(crate) active: Vec<bool>,
    /// For each component the index of its state.
    pub(crate) states: Vec<Option<usize>>,
}

impl TreeNow {
    /// Whether a link is in use: its owner is active, and in the state that the link belongs to.
    pub(crate) fn uses(&self, node: usize, link: &Link) -> bool {
        self.active[node] && (link.state.is_none() || link.state == self.states[node])
    }

    /// The name of the state of an active state machine.
    pub(crate) fn state(&self, node: usize) -> Option<&'static str> {
        let state = self.states[node].filter(|_| self.active[node])?;
        self.graph.nodes[node].states.get(state).map(|state| state.name)
    }
}
