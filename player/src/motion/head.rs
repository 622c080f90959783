//! The head.

use bica::prelude::*;
use bica_motion::head::HeadAngles;
use bica_motion::model::{HeadSpeed, RobotModel};
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::Model;
use crate::input::RobotState;
use crate::output::Motors;

/// Speed limits: below the motors' 6.5 rad/s, so that images are not blurred.
const SPEED: HeadSpeed = HeadSpeed { yaw: 4.0, pitch: 3.0 };
/// Maximum error of the measured joints at the target, rad.
const ARRIVED: f32 = 0.03;

/// Pan and tilt of the head, with limited speed and within the limits of the shell.
#[derive(Debug)]
pub struct Head {
    target: HeadAngles,
    commanded: HeadAngles,
    arrived: bool,
}

#[component(budget_us = 3)]
impl Head {
    /// Creates the component with the head straight ahead.
    #[must_use]
    pub const fn new() -> Self {
        Self { target: HeadAngles::AHEAD, commanded: HeadAngles::AHEAD, arrived: false }
    }

    fn step(&mut self, time: &Time, state: &RobotState, motors: &mut Motors) {
        self.commanded = SPEED.step::<Model>(self.commanded, self.target, time.dt());
        let measured = HeadAngles::read(state.angles());
        let near = |measured: f32, target: f32| fabsf(measured - target) < ARRIVED;
        self.arrived = near(measured.yaw, self.target.yaw) && near(measured.pitch, self.target.pitch);
        motors.set_head(self.commanded.yaw, self.commanded.pitch);
    }

    /// Sets the direction: `pan` rad to the left, `tilt` rad down, limited to the range of the joints. Values that are not
    /// finite are ignored.
    pub fn look_at(&mut self, pan: f32, tilt: f32) {
        if pan.is_finite() && tilt.is_finite() {
            let target = HeadAngles { yaw: pan, pitch: tilt }.clamped::<Model>();
            self.arrived &= target == self.target;
            self.target = target;
        }
    }

    /// Angle of a camera below the direction of the head, rad.
    #[must_use]
    pub const fn camera_tilt(camera: CameraId) -> f32 {
        Model::DIMENSIONS.camera(camera).tilt
    }

    /// The commanded head pan, rad to the left.
    #[must_use]
    pub const fn pan(&self) -> f32 {
        self.commanded.yaw
    }

    /// The commanded head tilt, rad down.
    #[must_use]
    pub const fn tilt(&self) -> f32 {
        self.commanded.pitch
    }

    /// Whether the head has reached its target.
    #[must_use]
    pub const fn arrived(&self) -> bool {
        self.arrived
    }
}
