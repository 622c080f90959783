//! The search for the ball: first where it is remembered, then everywhere.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use super::FaceBall;
use crate::motion::{Body, Head};
use crate::output::Gaze;
use crate::perception::BallDetector;

/// Where to look, one after the other: camera, head pan and tilt in rad.
///
/// Three bands, which overlap: the feet, up to 2 m, and the far field. Ahead first, then left, then right; the body turns
/// when all was looked at in vain.
const GLANCES: [(CameraId, f32, f32); 13] = [
    (CameraId::Bottom, 0.0, -0.1),
    (CameraId::Bottom, 0.0, 0.35),
    (CameraId::Top, 0.0, 0.0),
    (CameraId::Top, 0.85, 0.0),
    (CameraId::Bottom, 0.85, 0.35),
    (CameraId::Bottom, 0.85, -0.1),
    (CameraId::Bottom, 1.7, -0.1),
    (CameraId::Top, 1.7, 0.0),
    (CameraId::Top, -0.85, 0.0),
    (CameraId::Bottom, -0.85, 0.35),
    (CameraId::Bottom, -0.85, -0.1),
    (CameraId::Bottom, -1.7, -0.1),
    (CameraId::Top, -1.7, 0.0),
];
/// How long the head rests in each direction, s: two images and the motors' dead time.
const REST: f32 = 0.12;
/// How long to look for the ball where it is remembered, s: the way of the head, and some images.
const RECALL: f32 = 1.0;
/// A ball that is believed less than this is not looked for where it is remembered.
const BELIEVED: f32 = 0.1;
/// How fast the body turns when nothing was found, rad/s.
const TURN: f32 = 0.8;

/// Looks where the ball ought to be, then around with the head, then turns the body, until the ball is seen.
#[derive(Debug)]
pub struct SearchBall {
    glance: usize,
    rested: f32,
    /// For how long the remembered ball was looked for, s.
    recalled: f32,
}

#[component(hz = 50, budget_us = 5)]
impl SearchBall {
    /// Has not looked anywhere yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, rested: 0.0, recalled: 0.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    /// Looks where the ball ought to be, or roll by now.
    #[state(initial)]
    fn recall(&mut self, time: &Time, body: &mut Body, _face: &mut FaceBall) {
        body.stand();
        self.recalled += time.dt();
    }

    /// Nobody knows, or it is not there.
    #[transition(recall -> scan)]
    fn not_there(&self, ball: &BallDetector) -> bool {
        self.recalled > RECALL || ball.memory().confidence() < BELIEVED
    }

    /// Stands and moves the head.
    #[state]
    fn scan(&mut self, time: &Time, _ball: &BallDetector, head: &mut Head, gaze: &mut Gaze, body: &mut Body) {
        body.stand();
        let Some(&(camera, pan, tilt)) = GLANCES.get(self.glance) else { return };
        gaze.through(camera);
        head.look_at(pan, tilt);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > REST {
            self.rested = 0.0;
            self.glance += 1;
        }
    }

    /// Turns to where the head could not look.
    #[state]
    fn turn_around(&mut self, _ball: &BallDetector, head: &mut Head, gaze: &mut Gaze, body: &mut Body) {
        gaze.through(CameraId::Top);
        head.look_at(0.0, 0.0);
        body.turn(TURN);
        self.glance = 0;
    }

    #[transition(scan -> turn_around)]
    fn nothing_found(&self) -> bool {
        self.glance >= GLANCES.len()
    }

    #[transition(turn_around -> scan, after_ms = 2600)]
    fn turned(&self) -> bool {
        true
    }
}
