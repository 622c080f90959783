//! The search for the ball.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;

use super::FaceBall;
use crate::motion::{Body, Head};
use crate::output::CameraSelector;
use crate::perception::{BallDetector, CameraPose, FieldBoundary, Odometry, RobotDetector};
use crate::strategy::free_path;

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
/// Number of turns, of [`TURN_SPEED`] times 2.6 s each, in a full circle.
const TURNS: u8 = 3;
/// Free path ahead with which the robot begins to walk to another place, m.
const MIN_PATH: f32 = 1.25;
/// Free path ahead with which it ends its walk, m.
const BLOCKED_PATH: f32 = 0.8;
/// Head tilt with which the top camera shows the ground from 0.8 m to the horizon, rad.
const PATH_TILT: f32 = 0.25;
/// Walking speed to another place, m/s.
const WALK_SPEED: f32 = 0.2;
/// Distance to another place, m.
const WALK_DISTANCE: f32 = 1.0;

/// Searches the ball: at its remembered position, then with the head, then with turns of the body. After a full turn without
/// result it searches at another place, where other robots hide another part of the field.
#[derive(Debug)]
pub struct SearchBall {
    /// Index in [`GLANCES`].
    glance: usize,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// Duration of the search at the remembered position so far, s.
    recalled: f32,
    /// Number of turns at this place.
    turns: u8,
    /// Free path ahead, m, in the last run.
    path: f32,
    /// Pose in the frame of the odometry at the beginning of the walk to another place.
    left: Pose2,
    /// Walked distance from there, m.
    walked: f32,
}

#[component(hz = 50, budget_us = 5)]
impl SearchBall {
    /// Creates the component at the beginning of a search.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, rested: 0.0, recalled: 0.0, turns: 0, path: 0.0, left: Pose2::ORIGIN, walked: 0.0 }
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

    /// Turns on the spot until the path ahead is free.
    #[state]
    fn find_path(
        &mut self,
        _ball: &BallDetector,
        boundary: &FieldBoundary,
        camera: &CameraPose,
        robots: &RobotDetector,
        odometry: &Odometry,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, PATH_TILT);
        body.turn(TURN_SPEED);
        self.path = path_ahead(boundary, camera, robots);
        (self.left, self.walked) = (odometry.pose(), 0.0);
    }

    /// Walks to another place.
    #[state]
    fn walk_on(
        &mut self,
        _ball: &BallDetector,
        boundary: &FieldBoundary,
        camera: &CameraPose,
        robots: &RobotDetector,
        odometry: &Odometry,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, PATH_TILT);
        body.go(WALK_SPEED, 0.0);
        self.path = path_ahead(boundary, camera, robots);
        self.walked = odometry.pose().position.distance(self.left.position);
        (self.glance, self.turns) = (0, 0);
    }

    #[transition(scan -> find_path)]
    fn circle_complete(&self) -> bool {
        self.scan_complete() && self.turns >= TURNS
    }

    #[transition(scan -> turn_around)]
    fn scan_complete(&self) -> bool {
        self.glance >= GLANCES.len()
    }

    #[transition(turn_around -> scan, after_ms = 2600)]
    fn turned(&self) -> bool {
        true
    }

    #[exit(turn_around)]
    fn count_turn(&mut self) {
        self.turns += 1;
    }

    /// The head looks ahead again after this time.
    #[transition(find_path -> walk_on, after_ms = 500)]
    fn path_found(&self) -> bool {
        self.path >= MIN_PATH
    }

    /// No path is free in a full circle: the others may have moved after another one.
    #[transition(find_path -> scan, after_ms = 8000)]
    fn surrounded(&self) -> bool {
        true
    }

    #[transition(walk_on -> scan)]
    fn arrived(&self) -> bool {
        self.walked >= WALK_DISTANCE || self.path < BLOCKED_PATH
    }
}

fn path_ahead(boundary: &FieldBoundary, camera: &CameraPose, robots: &RobotDetector) -> f32 {
    let robots = robots.places().map(|place| place.position);
    camera.camera().map_or(0.0, |camera| free_path(boundary.line(), camera, robots))
}
