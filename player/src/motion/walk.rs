//! The walk.

use bica::prelude::*;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::side::Side;
use bica_motion::walk::{Phase, Velocity, Walk as Gait};

use crate::input::Measured;
use crate::output::Motors;

/// Walks with the velocity that is asked for; brings the feet together and stands when it is zero.
#[derive(Debug)]
pub struct Walk {
    gait: Gait,
    request: Velocity,
}

#[component(budget_us = 20)]
impl Walk {
    /// A walk that stands.
    #[must_use]
    pub const fn new() -> Self {
        Self { gait: Gait::new(&Nao::KINEMATIC_PROFILE.gait), request: Velocity::ZERO }
    }

    /// Whatever moved the body before has left it in the stand.
    #[start]
    fn begin(&mut self) {
        self.gait.reset();
        self.request = Velocity::ZERO;
    }

    fn step(&mut self, time: &Time, body: &Measured, motors: &mut Motors) {
        self.gait.set_gait(&body.profile().gait);
        let feedback = body.feedback();
        motors.limbs(&self.gait.step(self.request, &feedback, time.dt()));
    }

    /// Asks for a velocity: m/s and rad/s, seen from the robot.
    pub const fn request(&mut self, velocity: Velocity) {
        self.request = velocity;
    }

    /// Lets a foot swing through the ball in its next step.
    pub const fn kick(&mut self, foot: Side) {
        self.gait.request_kick(foot);
    }

    /// Whether both feet are together and still.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.gait.phase() == Phase::Standing
    }
}
