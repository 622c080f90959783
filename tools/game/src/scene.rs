//! A look at a game in progress: what the forward sees and believes, what is true, how the tree stands.

use bica::graph::Graph;
use bica::{ComponentId, Tree};
use bica_motion::pose::Pose2;
use bica_player::Forward;
use bica_player::input::CameraInput;
use bica_player::perception::{BallDetector, FieldBoundary, GoalDetector, Odometry, OwnBody};
use bica_sim::Referee;
use glam::Vec2;

use super::meter::Meter;
use bica_drawing::polar::Sight;
use bica_drawing::scene::{Beliefs, Marks, TreeNow, Truth};

/// The static description of the forward's tree.
pub static GRAPH: Graph = Forward::GRAPH;

/// A game after a cycle.
pub struct Scene<'a> {
    pub seed: u64,
    /// Time in the world when the forward thought, s.
    pub t: f64,
    pub robot: &'a Forward,
    pub referee: &'a Referee,
    pub meter: &'a Meter,
    /// Where the robot truly was when odometry began.
    pub start: Pose2,
    /// The way of the ball so far.
    pub trail: &'a [Vec2],
}

impl Scene<'_> {
    /// How the tree stands.
    pub fn tree(&self) -> TreeNow {
        let each = || (0..GRAPH.nodes.len()).map(ComponentId::new);
        TreeNow {
            graph: &GRAPH,
            active: each().map(|id| self.robot.is_active(id)).collect(),
            states: each().map(|id| self.robot.state(id)).collect(),
        }
    }

    /// What is recognised in the newest image, by the detectors that are active.
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

    /// What the forward believes.
    pub fn beliefs(&self) -> Beliefs {
        Beliefs {
            robot: self.start * self.robot.get::<Odometry>().pose(),
            ball: self.robot.get::<BallDetector>().position(),
            goal: self.robot.get::<GoalDetector>().position(),
        }
    }

    /// Where the forward believes ball and goal to be.
    pub fn sights(&self) -> (Option<Sight>, Option<Sight>) {
        let (beliefs, marks) = (self.beliefs(), self.marks());
        let ball = beliefs.ball.map(|at| Sight::new(at, marks.ball.is_some()));
        let goal = beliefs.goal.map(|at| Sight::new(at, !marks.goals.is_empty()));
        (ball, goal)
    }

    /// What is true.
    pub fn truth(&self) -> Truth {
        Truth {
            attacks: self.referee.attacks(),
            robot: self.referee.robot(),
            ball: self.referee.ball(),
            others: self.referee.others().to_vec(),
            trail: self.trail.to_vec(),
        }
    }

    /// The newest image's pixels and size.
    pub fn image(&self) -> Option<bica_motion::robot::Image<'_>> {
        Some(self.robot.get::<CameraInput>().image()).filter(|image| image.width > 0)
    }

    fn is_active<C: bica::Component>(&self) -> bool
    where
        Forward: bica::Has<C>,
    {
        self.robot.is_active(Forward::id::<C>())
    }
}
