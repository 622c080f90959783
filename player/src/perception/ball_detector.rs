//! The ball.

mod params;

use bica::prelude::*;
use bica::visual::{Ellipse, ImageCircle, Point2};
use bica_field::FIELD;
use bica_motion::model::RobotModel;
use bica_motion::robot::CameraId;
use bica_vision::ball::{Ball, BallDetection, BallFinder};
use bica_vision::frame::Frame;
use bica_vision::memory::ball::BallMemory;
use bica_vision::memory::{PositionEstimate, visibility};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{Bearing, CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{CameraInput, Colours};
use crate::{MODEL, shapes};

pub use params::BallTracking;

/// Finds the ball in the image and remembers its position while it is not seen.
pub struct BallDetector {
    model: &'static RobotModel,
    finder: BallFinder<512>,
    seen: Option<BallSighting>,
    in_row: u32,
    /// Minimum of `in_row` that confirms the ball.
    confirmations: u32,
    unseen_ms: u64,
    /// Minimum of `unseen_ms` at which the ball is lost.
    lost_after_ms: u64,
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
            model: MODEL,
            finder: BallFinder::new(FIELD.ball_radius()),
            seen: None,
            in_row: 0,
            confirmations: BallDetection::DEFAULT.confirmations,
            unseen_ms: BallDetection::DEFAULT.lost_after as u64,
            lost_after_ms: BallDetection::DEFAULT.lost_after as u64,
            memory: BallMemory::new(BallTracking::DEFAULT.half_life),
            ego_motion: EgoMotion::new(),
        }
    }

    /// Creates the component with a ball that was just seen at a position, m, in the ground frame.
    #[must_use]
    pub fn remembering(at: Vec2) -> Self {
        let mut detector = Self::new();
        detector.memory.see(at, &bica_vision::uncertainty::round(0.01), 1.0);
        detector.ego_motion.renew();
        detector
    }

    fn step(
        &mut self,
        detection: &Tuned<BallDetection>,
        tracking: &Tuned<BallTracking>,
        time: &Time,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.confirmations = detection.confirmations;
        self.lost_after_ms = detection.lost_after.into();
        self.memory.set_tuning(&tracking.tuning(odometry));
        self.unseen_ms = self.unseen_ms.saturating_add(time.since_run.as_millis());
        let advance = |motion, seconds| self.memory.advance(motion, seconds);
        if self.ego_motion.begin_run(time, odometry, input, advance) {
            self.model = pose.model();
            self.seen = self.look(detection, input, colours, end, pose, own);
            self.in_row = if self.seen.is_some() { self.in_row.saturating_add(1) } else { 0 };
            match self.seen {
                Some(seen) => self.remember(&seen, pose),
                None => self.reduce_confidence(tracking, input, pose, own),
            }
        }
    }

    fn look(
        &mut self,
        detection: &BallDetection,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
    ) -> Option<BallSighting> {
        let image = input.image();
        let (frame, camera) = (Frame::from_image(&image).ok()?, pose.camera()?);
        let ball = self.finder.find_tuned(
            &frame,
            colours.table(),
            end.line(),
            Some((camera, pose.errors())),
            own.body(),
            detection,
        )?;
        Some(BallSighting { ball, bearing: Bearing::of(camera.ray(ball.centre)), camera: image.camera })
    }

    fn remember(&mut self, seen: &BallSighting, pose: &CameraPose) {
        let (true, Some(camera)) = (self.is_confirmed(), pose.camera()) else { return };
        self.unseen_ms = 0;
        if let Some(PositionEstimate { position, covariance }) =
            seen.ball.estimate(camera, FIELD.ball_radius(), pose.errors())
        {
            self.memory.see(position, &covariance, seen.ball.confidence);
        }
    }

    /// Reduces the confidence in a remembered ball that a sharp image should show.
    fn reduce_confidence(&mut self, tracking: &BallTracking, input: &CameraInput, pose: &CameraPose, own: &OwnBody) {
        let Some((camera, place)) = pose.camera().zip(self.memory.likeliest()) else { return };
        let size = Vec2::new(input.image().width.into(), input.image().height.into());
        let far = tracking.visible_distance;
        if pose.is_steady() && visibility::is_in_view(camera, size, own.body(), &place, FIELD.ball_radius(), far) {
            self.memory.miss();
        }
    }

    /// Counts a cycle since the last run and the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// Whether it looks for the ball: it has processed an image in the last half second.
    #[output]
    #[must_use]
    pub const fn is_looking(&self) -> bool {
        self.ego_motion.has_image()
    }

    /// The ball in the newest image; `None` if that is older than half a second.
    #[must_use]
    pub const fn seen(&self) -> Option<&BallSighting> {
        if self.is_looking() { self.seen.as_ref() } else { None }
    }

    /// The ball in the newest image.
    #[output(unit = "px", frame = "camera")]
    fn ball_in_image(&self) -> Option<ImageCircle> {
        self.seen().map(|BallSighting { ball, .. }| ImageCircle {
            x: ball.centre.x,
            y: ball.centre.y,
            radius: ball.radius,
        })
    }

    /// Confidence in the ball of the newest image, 0 to 1.
    #[output]
    fn sighting_confidence(&self) -> Option<f32> {
        self.seen().map(|seen| seen.ball.confidence)
    }

    /// The camera whose newest image shows the ball.
    #[must_use]
    pub fn camera(&self) -> Option<CameraId> {
        self.seen().map(|seen| seen.camera)
    }

    /// Whether the ball was in the last images: in two, unless a parameter says otherwise.
    #[output]
    #[must_use]
    pub const fn is_confirmed(&self) -> bool {
        self.in_row >= self.confirmations && self.is_looking()
    }

    /// Whether the last confirmed sighting is old: at least 2 s, unless a parameter says otherwise; also if it does not look.
    #[output]
    #[must_use]
    pub const fn is_lost(&self) -> bool {
        self.unseen_ms >= self.lost_after_ms || !self.is_looking()
    }

    /// Time since the last confirmed sighting.
    #[output(unit = "ms")]
    const fn unseen_time(&self) -> u64 {
        self.unseen_ms
    }

    /// Bearing of the ball in the newest image, otherwise of its remembered position.
    #[output(unit = "rad")]
    #[must_use]
    pub fn bearing(&self) -> Option<Bearing> {
        let remembered = || self.position().map(|at| Bearing::of_ground(self.model, at, FIELD.ball_radius()));
        self.seen().map(|seen| seen.bearing).or_else(remembered)
    }

    /// Most probable position of the ball now, resting or rolling, m, in the ground frame between the feet; `None` if it is
    /// forgotten, or the motion of the robot is not known.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// Most probable position of the ball now.
    #[output(unit = "m", frame = "robot")]
    fn ball_position(&self) -> Option<Ellipse> {
        self.estimate().map(shapes::ellipse)
    }

    /// Velocity of the ball over the ground, x forward, y left; zero for a resting ball.
    #[output(unit = "m/s")]
    fn ball_velocity(&self) -> Point2 {
        shapes::point(self.memory().velocity())
    }

    /// Probability that the ball rolls, 0 to 1.
    #[output]
    fn rolling_probability(&self) -> f32 {
        self.memory().rolls()
    }

    /// Confidence in the position, 0 to 1.
    #[output]
    const fn position_confidence(&self) -> f32 {
        self.confidence()
    }

    /// Confidence in the remembered position, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.memory().confidence()
    }

    /// The same position with its covariance, m².
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.memory().likeliest()
    }

    /// The memory of the ball: velocity and confidence; an empty one if the motion of the robot is not known.
    #[must_use]
    pub const fn memory(&self) -> &BallMemory {
        const EMPTY: &BallMemory = &BallMemory::new(1.0);
        if self.ego_motion.is_fresh() { &self.memory } else { EMPTY }
    }
}
