//! The ball.

use bica::prelude::*;
use bica_field::FIELD;
use bica_motion::robot::CameraId;
use bica_vision::ball::{Ball, BallFinder};
use bica_vision::frame::Frame;
use bica_vision::memory::ball::BallMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use glam::Vec2;

use super::ride::Ride;
use super::{CameraPose, Direction, FieldBoundary, Odometry, OwnBody};
use crate::input::{Colours, Eye};

/// Sightings in a row that make sure.
const SURE: u8 = 2;
/// Time without a sighting after which the ball is lost, ms.
const LOST: u64 = 2000;

/// Time without a sighting in which the belief in the ball's place halves, s.
const HALF_LIFE: f32 = 2.0;
/// A ball farther away than this may be there and not be seen, m.
const VISIBLE: f32 = 2.5;

/// Finds the ball in the image and remembers where it lies while it is not seen.
pub struct BallDetector {
    finder: BallFinder<512>,
    seen: Option<Seen>,
    in_row: u8,
    unseen_ms: u64,
    memory: BallMemory,
    ride: Ride,
}

/// A ball in an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Centre and radius, px.
    pub ball: Ball,
    /// Where it was, seen from the torso.
    pub direction: Direction,
    /// The camera that saw it.
    pub camera: CameraId,
}

#[component(hz = 30, budget_us = 700)]
impl BallDetector {
    /// Knows of no ball.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            finder: BallFinder::new(FIELD.ball_radius()),
            seen: None,
            in_row: 0,
            unseen_ms: LOST,
            memory: BallMemory::new(HALF_LIFE),
            ride: Ride::new(),
        }
    }

    fn step(
        &mut self,
        time: &Time,
        eye: &Eye,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.unseen_ms = self.unseen_ms.saturating_add(time.since_run.as_millis());
        self.memory.advance(self.ride.motion(odometry), time.dt());
        if self.ride.sees_anew(eye) {
            self.seen = self.look(eye, colours, end, pose, own);
            self.in_row = if self.seen.is_some() { self.in_row.saturating_add(1) } else { 0 };
            match self.seen {
                Some(seen) => self.note(&seen, pose),
                None => self.note_absence(eye, pose, own),
            }
        }
    }

    fn look(
        &mut self,
        eye: &Eye,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
    ) -> Option<Seen> {
        let image = eye.image();
        let (frame, camera) = (Frame::from_image(&image).ok()?, pose.camera()?);
        let ball = self.finder.find_with_body(&frame, colours, end.line(), Some(camera), own.body())?;
        Some(Seen { ball, direction: Direction::of(camera.ray(ball.centre)), camera: image.camera })
    }

    fn note(&mut self, seen: &Seen, pose: &CameraPose) {
        let (true, Some(camera)) = (self.sure(), pose.camera()) else { return };
        self.unseen_ms = 0;
        if let Some(PositionEstimate { position, covariance }) = seen.ball.estimate(camera, FIELD.ball_radius()) {
            self.memory.see(position, &covariance, seen.ball.confidence);
        }
    }

    /// A ball that should be in a sharp image and is not is believed less.
    fn note_absence(&mut self, eye: &Eye, pose: &CameraPose, own: &OwnBody) {
        let Some((camera, place)) = pose.camera().zip(self.memory.likeliest()) else { return };
        let size = Vec2::new(eye.image().width.into(), eye.image().height.into());
        if pose.is_steady() && visibility::is_in_view(camera, size, own.body(), &place, FIELD.ball_radius(), VISIBLE) {
            self.memory.miss();
        }
    }

    /// The ball in the newest image.
    #[must_use]
    pub const fn seen(&self) -> Option<&Seen> {
        self.seen.as_ref()
    }

    /// Whether the ball was in the last images, one after the other.
    #[must_use]
    pub const fn sure(&self) -> bool {
        self.in_row >= SURE
    }

    /// Whether the ball has not been seen for two seconds.
    #[must_use]
    pub const fn lost(&self) -> bool {
        self.unseen_ms >= LOST
    }

    /// Where to look for the ball: where it is seen, else where it is believed to lie.
    #[must_use]
    pub fn direction(&self) -> Option<Direction> {
        let remembered = || self.at().map(|at| Direction::of_ground(at, FIELD.ball_radius()));
        self.seen.map(|seen| seen.direction).or_else(remembered)
    }

    /// Where the ball is believed to lie or to roll now, m, in the frame on the ground between the feet.
    #[must_use]
    pub fn at(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// The same, with how sure that is.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.memory.likeliest()
    }

    /// What is remembered of the ball: whether it rolls, where to, how much it is believed.
    #[must_use]
    pub const fn memory(&self) -> &BallMemory {
        &self.memory
    }
}
