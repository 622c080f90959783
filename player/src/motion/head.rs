//! The head.

use bica::prelude::*;
use bica_motion::head::HeadAngles;
use bica_motion::model::{HeadSpeed, RobotModel};
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::MODEL;
use crate::input::RobotState;
use crate::output::Motors;

/// How the head moves.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct HeadMotion {
    /// Largest pan speed: below the motors' 6.5 rad/s, so that images are not blurred.
    #[param(default = 4.0, range = 0.5..=6.5, unit = "rad/s", step = 0.1)]
    pub pan_speed: f32,
    /// Largest tilt speed: below the motors' 6.5 rad/s, so that images are not blurred.
    #[param(default = 3.0, range = 0.5..=6.5, unit = "rad/s", step = 0.1)]
    pub tilt_speed: f32,
    /// Largest error of each measured joint at which the target counts as reached.
    #[param(default = 0.03, range = 0.005..=0.2, unit = "rad", step = 0.005)]
    pub arrival_tolerance: f32,
    /// Time after which the target counts as reached although the head is not there: a joint may be blocked. A fault needs 1 s.
    #[param(default = 1.5, range = 0.2..=10.0, unit = "s", step = 0.1)]
    pub max_wait: f32,
    /// Stiffness of both joints, 0 (limp) to 1 (B-Human 2023).
    #[param(default = 0.7, range = 0.1..=1.0, step = 0.05)]
    pub stiffness: f32,
}

/// Pan and tilt of the head, with limited speed and within the limits of the shell.
#[derive(Debug)]
pub struct Head {
    model: &'static RobotModel,
    target: HeadAngles,
    commanded: HeadAngles,
    /// Time for which the target has been commanded, s.
    waited: f32,
    arrived: bool,
}

#[component(budget_us = 3, writers = first)]
impl Head {
    /// Creates the component with the head straight ahead.
    #[must_use]
    pub const fn new() -> Self {
        Self { model: MODEL, target: HeadAngles::AHEAD, commanded: HeadAngles::AHEAD, waited: 0.0, arrived: false }
    }

    fn step(&mut self, tuned: &Tuned<HeadMotion>, time: &Time, state: &RobotState, motors: &mut Motors) {
        let speed = HeadSpeed { yaw: tuned.pan_speed, pitch: tuned.tilt_speed };
        self.commanded = speed.step(self.model, self.commanded, self.target, time.dt());
        let measured = HeadAngles::read(state.angles());
        let near = |measured: f32, target: f32| fabsf(measured - target) < tuned.arrival_tolerance;
        self.waited = if self.commanded == self.target { self.waited + time.dt() } else { 0.0 };
        let is_near = near(measured.yaw, self.target.yaw) && near(measured.pitch, self.target.pitch);
        self.arrived = is_near || self.waited > tuned.max_wait;
        motors.set_head(self.commanded.yaw, self.commanded.pitch, tuned.stiffness);
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.model = model;
    }

    /// Sets the direction: `pan` rad to the left, `tilt` rad down, limited to the range of the joints. Values that are not
    /// finite are ignored.
    #[modulation(drives)]
    pub fn look_at(
        &mut self,
        /// Angle to the left.
        #[range(-2.1..=2.1)]
        #[unit("rad")]
        #[step(0.05)]
        pan: f32,
        /// Angle down.
        #[range(-0.7..=0.55)]
        #[unit("rad")]
        #[step(0.05)]
        tilt: f32,
    ) {
        if pan.is_finite() && tilt.is_finite() {
            let target = HeadAngles { yaw: pan, pitch: tilt }.clamped(self.model);
            self.arrived &= target == self.target;
            self.target = target;
        }
    }

    /// Angle of a camera below the direction of the head, rad.
    #[must_use]
    pub const fn camera_tilt(&self, camera: CameraId) -> f32 {
        self.model.dimensions.camera(camera).tilt
    }

    /// The commanded head pan, rad to the left.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn pan(&self) -> f32 {
        self.commanded.yaw
    }

    /// The commanded head tilt, rad down.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn tilt(&self) -> f32 {
        self.commanded.pitch
    }

    /// The requested direction within the limits of the joints.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn target(&self) -> HeadAngles {
        self.target
    }

    /// Whether the head has reached its target, or come as near as it can.
    #[output]
    #[must_use]
    pub const fn arrived(&self) -> bool {
        self.arrived
    }
}
