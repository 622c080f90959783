//! Walking.

use bica::prelude::*;
use bica_motion::model::RobotModel;
use bica_motion::side::Side;
use bica_motion::walk::{Phase, Velocity, Walk as Gait};

use crate::Model;
use crate::input::{RobotProfile, RobotState};
use crate::output::Motors;

/// Walks with the requested velocity; at zero velocity it brings the feet together and stands.
#[derive(Debug)]
pub struct Walk {
    gait: Gait<Model>,
    request: Velocity,
}

#[component(budget_us = 20)]
impl Walk {
    /// Creates the component in the stand.
    #[must_use]
    pub const fn new() -> Self {
        Self { gait: Gait::new(&Model::KINEMATIC_PROFILE.gait), request: Velocity::ZERO }
    }

    /// Every other motion ends in the stand, so the walk may be reset.
    #[start]
    fn begin(&mut self) {
        self.gait.reset();
        self.request = Velocity::ZERO;
    }

    fn step(&mut self, time: &Time, state: &RobotState, profile: &RobotProfile, motors: &mut Motors) {
        self.gait.set_gait(&profile.get().gait);
        let feedback = state.feedback();
        motors.set_limbs(&self.gait.step(self.request, &feedback, time.dt()));
    }

    /// Requests a velocity, in the frame of the robot.
    pub const fn request(&mut self, velocity: Velocity) {
        self.request = velocity;
    }

    /// Requests that a foot swings through the ball in its next step.
    pub const fn request_kick(&mut self, foot: Side) {
        self.gait.request_kick(foot);
    }

    /// Whether both feet are together and still.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.gait.phase() == Phase::Standing
    }
}
