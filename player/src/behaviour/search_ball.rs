//! The search for the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use super::FaceBall;
use crate::motion::{Body, Head};
use crate::output::CameraSelector;
use crate::perception::BallDetector;

/// Camera, head pan (rad) and head tilt (rad) in sequence.
///
/// Three overlapping bands: the feet, up to 2 m, and the far field; each ahead, then left, then right.
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
/// Duration of the stop in each direction, s: two images and the motors' dead time.
const REST_TIME: f32 = 0.12;
/// Duration of the search at the remembered position, s: the head motion and some images.
const RECALL_TIME: f32 = 1.0;
/// Minimum confidence in the remembered position for a search there, 0 to 1.
const MIN_CONFIDENCE: f32 = 0.1;
/// Turning speed of the body after a scan without result, rad/s.
const TURN_SPEED: f32 = 0.8;

/// Searches the ball: at its remembered position, then with the head, then with turns of the body.
#[derive(Debug)]
pub struct SearchBall {
    /// Index in [`GLANCES`].
    glance: usize,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// Duration of the search at the remembered position so far, s.
    recalled: f32,
}

#[component(hz = 50, budget_us = 5)]
impl SearchBall {
    /// Creates the component at the beginning of a search.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, rested: 0.0, recalled: 0.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    /// Directs the head to the remembered position of the ball.
    #[state(initial)]
    fn recall(&mut self, time: &Time, body: &mut Body, _face: &mut FaceBall) {
        body.stand();
        self.recalled += time.dt();
    }

    /// Whether the ball is not at the remembered position, or none is remembered.
    #[transition(recall -> scan)]
    fn not_found(&self, ball: &BallDetector) -> bool {
        self.recalled > RECALL_TIME || ball.memory().confidence() < MIN_CONFIDENCE
    }

    /// Stands and scans with the head.
    #[state]
    fn scan(
        &mut self,
        time: &Time,
        _ball: &BallDetector,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        body.stand();
        let Some(&(camera, pan, tilt)) = GLANCES.get(self.glance) else { return };
        selector.select(camera);
        head.look_at(pan, tilt);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > REST_TIME {
            self.rested = 0.0;
            self.glance += 1;
        }
    }

    /// Turns the body to directions that the head cannot reach.
    #[state]
    fn turn_around(&mut self, _ball: &BallDetector, head: &mut Head, selector: &mut CameraSelector, body: &mut Body) {
        selector.select(CameraId::Top);
        head.look_at(0.0, 0.0);
        body.turn(TURN_SPEED);
        self.glance = 0;
    }

    #[transition(scan -> turn_around)]
    fn scan_complete(&self) -> bool {
        self.glance >= GLANCES.len()
    }

    #[transition(turn_around -> scan, after_ms = 2600)]
    fn turned(&self) -> bool {
        true
    }
}
