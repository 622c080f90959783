//! State of a game after a cycle.

use bica::Tree;
use bica::graph::Graph;
use bica_drawing::TreeState;
use bica_evaluation::polar::Polar;
use bica_motion::pose::Pose2;
use bica_player::perception::{BallDetector, GoalDetector};
use bica_player::tunable::Forward;
use bica_sim::Referee;
use bica_wire::model::Description;
use glam::Vec2;
use std::sync::LazyLock;

use crate::game::meter::Meter;

/// Static description of the forward's tree.
pub static GRAPH: Graph = Forward::GRAPH;

/// The same tree in the form for tools.
pub(crate) static TREE: LazyLock<Description> = LazyLock::new(|| Description::of(&GRAPH));

/// State of a game after a cycle.
pub struct Scene<'a> {
    /// Seed of the game.
    pub seed: u64,
    /// Simulated time of the cycle, s.
    pub t: f64,
    /// The forward.
    pub robot: &'a Forward,
    /// The referee.
    pub referee: &'a Referee,
    pub(crate) meter: &'a Meter,
    /// True pose at the start of odometry.
    pub start: Pose2,
    /// Path of the ball so far.
    pub ball_path: &'a [Vec2],
}

impl Scene<'_> {
    /// Returns the state of the tree.
    #[must_use]
    pub fn tree(&self) -> TreeState<'static> {
        TreeState::of(&TREE, self.robot)
    }

    /// Returns the estimated positions of ball and goal relative to the robot.
    pub(crate) fn positions(&self) -> (Option<Polar>, Option<Polar>) {
        let (ball, goal) = (self.robot.get::<BallDetector>(), self.robot.get::<GoalDetector>());
        let sees_ball = ball.seen().is_some() && self.is_active::<BallDetector>();
        let sees_goal = goal.seen().is_some() && self.is_active::<GoalDetector>();
        (ball.position().map(|at| Polar::new(at, sees_ball)), goal.position().map(|at| Polar::new(at, sees_goal)))
    }

    /// Returns whether a component is active in this cycle.
    pub(crate) fn is_active<C: bica::Component>(&self) -> bool
    where
        Forward: bica::Has<C>,
    {
        self.robot.of::<C>().is_active()
    }
}
