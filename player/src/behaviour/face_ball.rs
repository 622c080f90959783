//! Control of head and camera selection: keeps the ball in the middle of the image.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::motion::Head;
use crate::output::CameraSelector;
use crate::perception::{BallDetector, Bearing};

/// Minimum angle below the horizon for the bottom camera, rad.
const NEAR: f32 = 0.5;
/// Maximum angle below the horizon for the top camera, rad.
const FAR: f32 = 0.36;
/// Share of the error that the head corrects in a run.
const GAIN: f32 = 0.7;
/// Largest angle to the middle of the image at which the ball is centred, rad.
const CENTRED: f32 = 0.15;

/// Keeps the ball in the middle of the image of the more suitable camera. While the ball is not seen, the head points to its
/// remembered position.
#[derive(Debug)]
pub struct FaceBall {
    centred: bool,
}

#[component(hz = 30, budget_us = 5)]
impl FaceBall {
    /// Creates the component with the ball not centred.
    #[must_use]
    pub const fn new() -> Self {
        Self { centred: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, ball: &BallDetector, head: &mut Head, camera: &mut CameraSelector) {
        let Some(Bearing { pan, down }) = ball.bearing() else { return };
        let before = camera.selected();
        match before {
            CameraId::Top if down > NEAR => camera.select(CameraId::Bottom),
            CameraId::Bottom if down < FAR => camera.select(CameraId::Top),
            _ => {}
        }
        let tilt = down - Head::camera_tilt(camera.selected());
        let (from_pan, from_tilt) = (head.pan(), head.tilt());
        let gain = if camera.selected() == before { GAIN } else { 1.0 };
        self.centred = ball.seen().is_some() && fabsf(pan - from_pan) < CENTRED && fabsf(tilt - from_tilt) < CENTRED;
        head.look_at(from_pan + gain * (pan - from_pan), from_tilt + gain * (tilt - from_tilt));
    }

    /// Whether the ball is in the middle of the newest image.
    #[must_use]
    pub const fn centred(&self) -> bool {
        self.centred
    }
}
