//! State of a game after a cycle: detections and estimates of the forward, the true state, the tree.

use bica::graph::Graph;
use bica::{ComponentId, Tree};
use bica_drawing::TreeState;
use bica_drawing::polar::Polar;
use bica_evaluation::pictures::Marks;
use bica_motion::pose::Pose2;
use bica_player::input::CameraInput;
use bica_player::perception::{BallDetector, FieldBoundary, GoalDetector, Odometry, OwnBody};
use bica_player::tunable::Forward;
use bica_sim::Referee;
use bica_wire::model::Description;
use glam::Vec2;
use std::sync::LazyLock;

use crate::game::meter::Meter;
use crate::game::pictures::state::{Estimates, GroundTruth};

/// Static description of the forward's tree.
pub static GRAPH: Graph = Forward::GRAPH;

/// The same tree as tools describe it.
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
        let each = || (0..GRAPH.nodes.len()).map(ComponentId::new);
        TreeState {
            tree: &TREE,
            active: each().map(|id| self.robot.is_active_at(id)).collect(),
            states: each().map(|id| self.robot.state(id)).collect(),
        }
    }

    /// Returns the detections in the newest image, of the active detectors.
    #[must_use]
    pub fn marks(&self) -> Marks {
        let ball = self.robot.get::<BallDetector>().seen().filter(|_| self.is_active::<BallDetector>());
        let net = self.robot.get::<GoalDetector>().seen().filter(|_| self.is_active::<GoalDetector>());
        let end = Some(self.robot.get::<FieldBoundary>().line()).filter(|_| self.is_active::<FieldBoundary>());
        Marks {
            ball: ball.map(|seen| seen.ball),
            goals: net.copied().into_iter().collect(),
            field_boundary: end.map_or(Vec::new(), |line| line.corners().to_vec()),
            own: self.robot.get::<OwnBody>().body().clone(),
            ..Marks::default()
        }
    }

    /// Returns the estimates of the forward.
    #[must_use]
    pub fn estimates(&self) -> Estimates {
        Estimates {
            robot: self.start * self.robot.get::<Odometry>().pose(),
            ball: self.robot.get::<BallDetector>().position(),
            goal: self.robot.get::<GoalDetector>().position(),
        }
    }

    /// Returns the estimated positions of ball and goal relative to the robot.
    #[must_use]
    pub fn positions(&self) -> (Option<Polar>, Option<Polar>) {
        let (estimates, marks) = (self.estimates(), self.marks());
        let ball = estimates.ball.map(|at| Polar::new(at, marks.ball.is_some()));
        let goal = estimates.goal.map(|at| Polar::new(at, !marks.goals.is_empty()));
        (ball, goal)
    }

    /// Returns the true state.
    #[must_use]
    pub fn truth(&self) -> GroundTruth {
        GroundTruth {
            attacks: self.referee.attacks(),
            robot: self.referee.robot(),
            ball: self.referee.ball(),
            others: self.referee.others().to_vec(),
            trail: self.ball_path.to_vec(),
        }
    }

    /// Returns the newest image, if there is one.
    #[must_use]
    pub fn image(&self) -> Option<bica_motion::robot::Image<'_>> {
        Some(self.robot.get::<CameraInput>().image()).filter(|image| image.width > 0)
    }

    fn is_active<C: bica::Component>(&self) -> bool
    where
        Forward: bica::Has<C>,
    {
        self.robot.is_active::<C>()
    }
}
