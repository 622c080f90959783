//! Walking.

use bica::prelude::*;
use bica_motion::model::RobotModel;
use bica_motion::side::Side;
use bica_motion::walk::{Adjustment, Phase, Velocity, Walk as Gait};

use crate::MODEL;
use crate::input::{RobotProfile, RobotState};
use crate::output::Motors;

/// Adjustment of the gait of the robot's profile to a floor.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct WalkTuning {
    /// Scale of the largest speeds of the gait.
    #[param(default = 1.0, range = 0.2..=1.3, step = 0.05)]
    pub speed_limit_scale: f32,
    /// Scale of the height of the swing foot. A soft floor needs more.
    #[param(default = 1.0, range = 0.5..=2.0, step = 0.05)]
    pub step_height_scale: f32,
    /// Scale of the gains from the gyroscope to the ankles.
    #[param(default = 1.0, range = 0.0..=2.0, step = 0.05)]
    pub balance_scale: f32,
    /// Additional forward lean of the torso, in stand and walk. `Kicker.torso_lean` should equal it.
    #[param(default = 0.0, range = -0.1..=0.1, unit = "rad", step = 0.005)]
    pub torso_lean: f32,
    /// Forward speed that is added to every requested velocity except zero. It compensates drift.
    #[param(default = 0.0, range = -0.05..=0.05, unit = "m/s", step = 0.002)]
    pub forward_trim: f32,
    /// Speed to the left that is added to every requested velocity except zero.
    #[param(default = 0.0, range = -0.05..=0.05, unit = "m/s", step = 0.002)]
    pub left_trim: f32,
    /// Turning speed, positive to the left, that is added to every requested velocity except zero.
    #[param(default = 0.0, range = -0.3..=0.3, unit = "rad/s", step = 0.01)]
    pub turn_trim: f32,
}

impl WalkTuning {
    const fn adjustment(&self) -> Adjustment {
        Adjustment {
            speed_limit: self.speed_limit_scale,
            step_height: self.step_height_scale,
            balance: self.balance_scale,
            torso_lean: self.torso_lean,
        }
    }

    /// The requested velocity with the trim.
    fn trimmed(&self, request: Velocity) -> Velocity {
        if request.is_zero() {
            return request;
        }
        Velocity {
            forward: request.forward + self.forward_trim,
            left: request.left + self.left_trim,
            turn: request.turn + self.turn_trim,
        }
    }
}

/// Walks with the requested velocity; at zero velocity it brings the feet together and stands.
#[derive(Debug)]
pub struct Walk {
    gait: Gait,
    request: Velocity,
}

#[component(budget_us = 20, writers = first)]
impl Walk {
    /// Creates the component in the stand.
    #[must_use]
    pub const fn new() -> Self {
        Self { gait: Gait::new(MODEL, &MODEL.kinematic_profile.gait), request: Velocity::ZERO }
    }

    /// Every other motion ends in the stand, so the walk may be reset.
    #[start]
    fn begin(&mut self) {
        self.gait.reset();
        self.request = Velocity::ZERO;
    }

    fn step(
        &mut self,
        tuned: &Tuned<WalkTuning>,
        time: &Time,
        state: &RobotState,
        profile: &RobotProfile,
        motors: &mut Motors,
    ) {
        self.gait.set_gait(&profile.get().gait);
        self.gait.set_adjustment(tuned.adjustment());
        let feedback = state.feedback();
        motors.set_limbs(&self.gait.step(tuned.trimmed(self.request), &feedback, time.dt()));
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.gait = Gait::new(model, &model.kinematic_profile.gait);
    }

    /// Requests a velocity, in the frame of the robot.
    pub const fn request(&mut self, velocity: Velocity) {
        self.request = velocity;
    }

    /// Requests that a foot swings through the ball in its next step.
    pub const fn request_kick(&mut self, foot: Side) {
        self.gait.request_kick(foot);
    }

    /// The requested velocity, in the frame of the robot.
    #[output(unit = "m/s, rad/s")]
    #[must_use]
    pub const fn requested(&self) -> Velocity {
        self.request
    }

    /// Velocity of the current step, within the limits of the gait; zero in stand.
    #[output(unit = "m/s, rad/s")]
    #[must_use]
    pub const fn velocity(&self) -> Velocity {
        self.gait.velocity()
    }

    /// Phase of the walk.
    #[output]
    #[must_use]
    pub const fn phase(&self) -> Phase {
        self.gait.phase()
    }

    /// Planned support foot; `None` in stand.
    #[output]
    #[must_use]
    pub fn support(&self) -> Option<Side> {
        self.gait.support()
    }

    /// Whether both feet are together and still.
    #[output]
    #[must_use]
    pub fn stands(&self) -> bool {
        self.gait.phase() == Phase::Standing
    }
}
