//! The ball.

use bica::prelude::*;
use bica_field::FIELD;
use bica_motion::robot::CameraId;
use bica_vision::ball::{Ball, BallFinder};
use bica_vision::frame::Frame;
use bica_vision::memory::ball::BallMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{Bearing, CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{CameraInput, Colours};

/// Consecutive sightings that confirm the ball.
const SURE: u8 = 2;
/// Time without a confirmed sighting after which the ball is lost, ms.
const LOST: u64 = 2000;

/// Half-life of the confidence in a ball that is not seen, s.
const HALF_LIFE: f32 = 2.0;
/// Distance up to which a ball in view is always detected, m.
const VISIBLE: f32 = 2.5;

/// Finds the ball in the image and remembers its position while it is not seen.
pub struct BallDetector {
    finder: BallFinder<512>,
    seen: Option<BallSighting>,
    in_row: u8,
    unseen_ms: u64,
    memory: BallMemory,
    ego_motion: EgoMotion,
}

/// Ball in an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallSighting {
    /// Centre and radius, px.
    pub ball: Ball,
    /// Bearing of its centre.
    pub bearing: Bearing,
    /// Camera that took the image.
    pub camera: CameraId,
}

#[component(hz = 30, budget_us = 700)]
impl BallDetector {
    /// Creates the component without a ball.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            finder: BallFinder::new(FIELD.ball_radius()),
            seen: None,
            in_row: 0,
            unseen_ms: LOST,
            memory: BallMemory::new(HALF_LIFE),
            ego_motion: EgoMotion::new(),
        }
    }

    fn step(
        &mut self,
        time: &Time,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.unseen_ms = self.unseen_ms.saturating_add(time.since_run.as_millis());
        let advance = |motion| self.memory.advance(motion, time.dt());
        if self.ego_motion.begin_run(odometry, input, advance) {
            self.seen = self.look(input, colours, end, pose, own);
            self.in_row = if self.seen.is_some() { self.in_row.saturating_add(1) } else { 0 };
            match self.seen {
                Some(seen) => self.remember(&seen, pose),
                None => self.reduce_confidence(input, pose, own),
            }
        }
    }

    fn look(
        &mut self,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
    ) -> Option<BallSighting> {
        let image = input.image();
        let (frame, camera) = (Frame::from_image(&image).ok()?, pose.camera()?);
        let ball = self.finder.find_with_body(&frame, colours, end.line(), Some(camera), own.body())?;
        Some(BallSighting { ball, bearing: Bearing::of(camera.ray(ball.centre)), camera: image.camera })
    }

    fn remember(&mut self, seen: &BallSighting, pose: &CameraPose) {
        let (true, Some(camera)) = (self.is_confirmed(), pose.camera()) else { return };
        self.unseen_ms = 0;
        if let Some(PositionEstimate { position, covariance }) = seen.ball.estimate(camera, FIELD.ball_radius()) {
            self.memory.see(position, &covariance, seen.ball.confidence);
        }
    }

    /// Reduces the confidence in a remembered ball that a sharp image should show.
    fn reduce_confidence(&mut self, input: &CameraInput, pose: &CameraPose, own: &OwnBody) {
        let Some((camera, place)) = pose.camera().zip(self.memory.likeliest()) else { return };
        let size = Vec2::new(input.image().width.into(), input.image().height.into());
        if pose.is_steady() && visibility::is_in_view(camera, size, own.body(), &place, FIELD.ball_radius(), VISIBLE) {
            self.memory.miss();
        }
    }

    /// The ball in the newest image.
    #[must_use]
    pub const fn seen(&self) -> Option<&BallSighting> {
        self.seen.as_ref()
    }

    /// Whether the ball was in the last two images.
    #[must_use]
    pub const fn is_confirmed(&self) -> bool {
        self.in_row >= SURE
    }

    /// Whether the last confirmed sighting is at least 2 s old.
    #[must_use]
    pub const fn is_lost(&self) -> bool {
        self.unseen_ms >= LOST
    }

    /// Bearing of the ball in the newest image, otherwise of its remembered position.
    #[must_use]
    pub fn bearing(&self) -> Option<Bearing> {
        let remembered = || self.position().map(|at| Bearing::of_ground(at, FIELD.ball_radius()));
        self.seen.map(|seen| seen.bearing).or_else(remembered)
    }

    /// Most probable position of the ball now, resting or rolling, m, in the ground frame between the feet.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// The same position with its covariance, m².
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.memory.likeliest()
    }

    /// The memory of the ball: velocity and confidence.
    #[must_use]
    pub const fn memory(&self) -> &BallMemory {
        &self.memory
    }
}
