//! The ball.

use bica::prelude::*;
use bica::visual::{Ellipse, Point2};
use bica_motion::model::RobotModel;
use bica_motion::robot::CameraId;
use bica_vision::memory::ball::BallMemory;
use bica_vision::memory::{BallMemoryTuning, MemoryTuning, PositionEstimate};
use bica_vision::uncertainty;
use glam::Vec2;

use super::CameraPose;
use crate::league::FIELD;
use crate::league::input::CameraInput;
use crate::league::senses::Object;
use crate::output::CameraSelector;
use crate::perception::ego_motion::EgoMotion;
use crate::perception::{Bearing, Odometry};
use crate::{MODEL, shapes};

/// Memory of the ball.
#[derive(Debug, Params)]
pub struct BallTracking {
    /// Number of views in a row that confirm the ball.
    #[param(default = 2, range = 1..=10)]
    confirmations: u32,
    /// Time since the last confirmed sighting after which the ball is lost.
    #[param(default = 2000, range = 100..=10000, unit = "ms")]
    lost_after: u32,
    /// Deceleration of the rolling ball.
    #[param(default = 0.3, range = 0.05..=3.0, unit = "m/s²", step = 0.01)]
    deceleration: f32,
    /// Standard deviation of a sighting, in each direction.
    #[param(default = 0.02, range = 0.001..=0.5, unit = "m", step = 0.001)]
    sighting_error: f32,
}

/// Sees the ball and remembers its position while it is not seen.
#[derive(Debug)]
pub struct BallDetector {
    model: &'static RobotModel,
    seen: Option<BallSighting>,
    in_row: u32,
    confirmations: u32,
    unseen_ms: u64,
    lost_after_ms: u64,
    memory: BallMemory,
    ego_motion: EgoMotion,
}

/// The ball in a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallSighting {
    /// Bearing of its centre.
    pub bearing: Bearing,
    /// Camera that took the view: the robot has one under both names.
    pub camera: CameraId,
}

#[component(hz = 30, budget_us = 20)]
impl BallDetector {
    /// Creates the component without a ball.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            model: MODEL,
            seen: None,
            in_row: 0,
            confirmations: BallTracking::DEFAULT.confirmations,
            unseen_ms: BallTracking::DEFAULT.lost_after as u64,
            lost_after_ms: BallTracking::DEFAULT.lost_after as u64,
            memory: BallMemory::new(MemoryTuning::DEFAULT.half_life),
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
        tuned: &Tuned<BallTracking>,
        time: &Time,
        input: &CameraInput,
        selector: &CameraSelector,
        pose: &CameraPose,
        odometry: &Odometry,
    ) {
        (self.confirmations, self.lost_after_ms) = (tuned.confirmations, tuned.lost_after.into());
        let memory = MemoryTuning {
            distance_error: odometry.distance_error(),
            turn_error: odometry.turn_error(),
            ..MemoryTuning::DEFAULT
        };
        let tuning = BallMemoryTuning { memory, deceleration: tuned.deceleration, ..BallMemoryTuning::DEFAULT };
        self.memory.set_tuning(&tuning);
        self.unseen_ms = self.unseen_ms.saturating_add(time.since_run.as_millis());
        let advance = |motion, seconds| self.memory.advance(motion, seconds);
        if !self.ego_motion.begin_run(time, odometry, input, advance) {
            return;
        }
        self.model = pose.model();
        let ball = input.sights().iter().find(|sight| sight.object == Object::Ball);
        self.seen = ball.and_then(|ball| {
            let bearing = Bearing::of(pose.direction(ball.at)?);
            Some(BallSighting { bearing, camera: selector.selected() })
        });
        self.in_row = if self.seen.is_some() { self.in_row.saturating_add(1) } else { 0 };
        if let (true, Some(ball)) = (self.is_confirmed(), ball)
            && let Some(at) = pose.ground(ball.at, FIELD.ball_radius())
        {
            self.unseen_ms = 0;
            self.memory.see(at, &uncertainty::round(tuned.sighting_error), 1.0);
        }
    }

    /// Counts a cycle since the last run and the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// Whether it looks for the ball: it has processed a view in the last half second.
    #[output]
    #[must_use]
    pub const fn is_looking(&self) -> bool {
        self.ego_motion.has_image()
    }

    /// The ball in the newest view; `None` if that is older than half a second.
    #[must_use]
    pub const fn seen(&self) -> Option<&BallSighting> {
        if self.is_looking() { self.seen.as_ref() } else { None }
    }

    /// The camera whose newest view shows the ball.
    #[must_use]
    pub fn camera(&self) -> Option<CameraId> {
        self.seen().map(|seen| seen.camera)
    }

    /// Confidence in the remembered position, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.memory().confidence()
    }

    /// Whether the ball was in the last views: in two, unless a parameter says otherwise.
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

    /// Bearing of the ball in the newest view, otherwise of its remembered position.
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
