//! Parameters of the planning.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickKind};

/// How the forward plans at the ball. Costs are in rad of turning.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Planning {
    /// Largest turn of an alignment; a larger one needs a path around the ball.
    #[param(default = 0.6, range = 0.1..=1.5, unit = "rad", step = 0.05)]
    pub max_alignment: f32,
    /// Turn around the ball, positive to the left, if no goal was seen: it is assumed behind the robot.
    #[param(default = 2.5, range = -3.1..=3.1, unit = "rad", step = 0.1)]
    pub unknown_goal_turn: f32,
    /// Cost of a path around the ball: above the cost of every kick without one.
    #[param(default = 10.0, range = 0.0..=30.0, unit = "rad", step = 0.5)]
    pub circling_cost: f32,
    /// Weight of the cost of a kick in addition to a path around the ball.
    #[param(default = 4.0, range = 0.0..=10.0, step = 0.5)]
    pub circling_weight: f32,
    /// Additional cost of the last failed kick.
    #[param(default = 1.0, range = 0.0..=10.0, unit = "rad", step = 0.1)]
    pub repetition_cost: f32,
    /// Cost of the front kick in addition to the turning. It is the most reliable.
    #[param(default = 0.0, range = 0.0..=5.0, unit = "rad", step = 0.05)]
    pub front_cost: f32,
    /// Cost of a diagonal kick in addition to the turning.
    #[param(default = 0.25, range = 0.0..=5.0, unit = "rad", step = 0.05)]
    pub diagonal_cost: f32,
    /// Cost of a lateral kick in addition to the turning.
    #[param(default = 0.4, range = 0.0..=5.0, unit = "rad", step = 0.05)]
    pub lateral_cost: f32,
    /// Offset of the target from the middle of the goal while the gap is unknown: the keeper is in the middle.
    #[param(default = 0.38, range = 0.0..=0.7, unit = "m", step = 0.02)]
    pub keeper_offset: f32,
    /// Distance of the outermost target from the middle of the goal, as a share of the distance to the post.
    #[param(default = 0.75, range = 0.1..=1.0, step = 0.05)]
    pub outermost_target: f32,
    /// Cost per distance from the best target.
    #[param(default = 1.0, range = 0.0..=10.0, unit = "rad/m", step = 0.1)]
    pub offset_cost: f32,
    /// Distance from the goal line of the targets in front of the goal, for a ball without a free path into it.
    #[param(default = 1.2, range = 0.2..=3.0, unit = "m", step = 0.1)]
    pub before_distance: f32,
    /// Offset along the goal line of the outer targets in front of the goal.
    #[param(default = 0.6, range = 0.0..=2.0, unit = "m", step = 0.1)]
    pub before_offset: f32,
    /// Cost of the outer targets in front of the goal.
    #[param(default = 0.4, range = 0.0..=5.0, unit = "rad", step = 0.05)]
    pub before_offset_cost: f32,
}

impl Planning {
    /// Cost of a kick in addition to the turning, rad.
    pub(super) const fn kick_cost(&self, kick: Kick) -> f32 {
        match kick.kind {
            KickKind::Front => self.front_cost,
            KickKind::Diagonal => self.diagonal_cost,
            KickKind::Lateral => self.lateral_cost,
        }
    }
}
