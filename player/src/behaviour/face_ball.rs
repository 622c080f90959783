//! Eyes on the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::motion::Head;
use crate::output::Gaze;
use crate::perception::{BallDetector, Direction};

/// A ball farther down than this is for the bottom camera, rad below the horizon.
const NEAR: f32 = 0.5;
/// A ball less far down than this is for the top camera, rad below the horizon.
const FAR: f32 = 0.36;
/// Part of the way to the ball that the head goes in a run.
const GAIN: f32 = 0.7;

/// How near the middle of the image the ball is in the middle, rad.
const CENTRED: f32 = 0.15;

/// Keeps the ball in the middle of the image, with the camera that sees it best; a ball that is not seen is looked for
/// where it is remembered.
#[derive(Debug)]
pub struct FaceBall {
    centred: bool,
}

#[component(hz = 30, budget_us = 5)]
impl FaceBall {
    /// Faces nothing yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { centred: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, ball: &BallDetector, head: &mut Head, gaze: &mut Gaze) {
        let Some(Direction { pan, down }) = ball.direction() else { return };
        let before = gaze.camera();
        match before {
            CameraId::Top if down > NEAR => gaze.through(CameraId::Bottom),
            CameraId::Bottom if down < FAR => gaze.through(CameraId::Top),
            _ => {}
        }
        let tilt = down - Head::mounted(gaze.camera());
        let (from_pan, from_tilt) = (head.pan(), head.tilt());
        let gain = if gaze.camera() == before { GAIN } else { 1.0 };
        self.centred = ball.seen().is_some() && fabsf(pan - from_pan) < CENTRED && fabsf(tilt - from_tilt) < CENTRED;
        head.look_at(from_pan + gain * (pan - from_pan), from_tilt + gain * (tilt - from_tilt));
    }

    /// Whether the ball is seen in the middle of the image, so that the head's direction is the ball's.
    #[must_use]
    pub const fn centred(&self) -> bool {
        self.centred
    }
}
