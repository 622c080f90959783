//! The head.

use bica::prelude::*;
use bica_motion::head::HeadAngles;
use bica_motion::model::{HeadSpeed, Nao, RobotModel};
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::input::Measured;
use crate::output::Motors;

/// Fast, yet below what the motors can (6.5 rad/s), so that images stay sharp.
const SPEED: HeadSpeed = HeadSpeed { yaw: 4.0, pitch: 3.0 };
/// How near the measured joints must be to count as arrived, rad.
const ARRIVED: f32 = 0.03;

/// Pan and tilt of the head, at a limited speed and within what the shell allows.
#[derive(Debug)]
pub struct Head {
    wanted: HeadAngles,
    commanded: HeadAngles,
    arrived: bool,
}

#[component(budget_us = 3)]
impl Head {
    /// A head that looks ahead.
    #[must_use]
    pub const fn new() -> Self {
        Self { wanted: HeadAngles::AHEAD, commanded: HeadAngles::AHEAD, arrived: false }
    }

    fn step(&mut self, time: &Time, body: &Measured, motors: &mut Motors) {
        self.commanded = SPEED.step::<Nao>(self.commanded, self.wanted, time.dt());
        let measured = HeadAngles::read(body.angles());
        let near = |measured: f32, wanted: f32| fabsf(measured - wanted) < ARRIVED;
        self.arrived = near(measured.yaw, self.wanted.yaw) && near(measured.pitch, self.wanted.pitch);
        motors.head(self.commanded.yaw, self.commanded.pitch);
    }

    /// Looks in a direction: `pan` rad to the left, `tilt` rad down. What is out of reach is brought into it, what is no
    /// number is not done.
    pub fn look_at(&mut self, pan: f32, tilt: f32) {
        if pan.is_finite() && tilt.is_finite() {
            let wanted = HeadAngles { yaw: pan, pitch: tilt }.clamped::<Nao>();
            self.arrived &= wanted == self.wanted;
            self.wanted = wanted;
        }
    }

    /// How far below the head's own direction a camera looks, rad.
    #[must_use]
    pub const fn mounted(camera: CameraId) -> f32 {
        Nao::DIMENSIONS.camera(camera).tilt
    }

    /// Head pan that was commanded last, rad to the left.
    #[must_use]
    pub const fn pan(&self) -> f32 {
        self.commanded.yaw
    }

    /// Head tilt that was commanded last, rad down.
    #[must_use]
    pub const fn tilt(&self) -> f32 {
        self.commanded.pitch
    }

    /// Whether the head looks where it was told to.
    #[must_use]
    pub const fn arrived(&self) -> bool {
        self.arrived
    }
}
