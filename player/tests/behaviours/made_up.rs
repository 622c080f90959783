//! Components whose values a test sets.

use bica::prelude::*;
use bica_field::{FIELD, FieldDimensions};
use bica_motion::fall::FallState;
use bica_motion::health::Fault;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_motion::walk::Velocity;
use bica_player::MODEL;
use bica_player::motion::Request;
use bica_player::perception::Bearing;
#[cfg(feature = "referee")]
use bica_player::roles::Whereabouts;
use bica_player::roles::{Ball, Carpet, Eye, Falls, Goal, Health, Legs, Odometer, Place, Robots};
use bica_vision::memory::PositionEstimate;
use bica_vision::projection::Camera;
use bica_vision::uncertainty;
use glam::Vec2;
#[cfg(feature = "referee")]
use glam::{Mat3, Vec3};

/// All that the behaviours see and measure.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a value that a provider measures by itself")]
pub(crate) struct Scene {
    pub(crate) ball: Option<Vec2>,
    pub(crate) bearing: Option<Bearing>,
    pub(crate) camera: Option<CameraId>,
    pub(crate) is_looking: bool,
    pub(crate) is_confirmed: bool,
    pub(crate) is_lost: bool,
    pub(crate) confidence: f32,
    pub(crate) goal: Option<Vec2>,
    pub(crate) goal_is_complete: bool,
    pub(crate) place: Option<Pose2>,
    pub(crate) walked: Pose2,
    pub(crate) fall: FallState,
    pub(crate) fault: Option<Fault>,
    pub(crate) must_stop: bool,
    /// Distance to the end of the field straight ahead, m.
    pub(crate) carpet_ahead: f32,
    pub(crate) robot: Option<Vec2>,
}

#[component]
impl Scene {
    pub(crate) const fn new() -> Self {
        Self {
            ball: None,
            bearing: None,
            camera: None,
            is_looking: true,
            is_confirmed: false,
            is_lost: false,
            confidence: 0.0,
            goal: None,
            goal_is_complete: false,
            place: None,
            walked: Pose2::ORIGIN,
            fall: FallState::Upright,
            fault: None,
            must_stop: false,
            carpet_ahead: 0.0,
            robot: None,
        }
    }

    /// The ball lies at a position, m, and the camera shows it.
    pub(crate) fn shows_ball(&mut self, at: Vec2) {
        (self.ball, self.confidence, self.is_confirmed, self.is_lost) = (Some(at), 1.0, true, false);
        (self.bearing, self.camera) = (Some(Bearing::of_ground(MODEL, at, 0.03)), Some(CameraId::Top));
    }
}

impl Ball for Scene {
    fn is_looking(&self) -> bool {
        self.is_looking
    }

    fn is_confirmed(&self) -> bool {
        self.is_confirmed
    }

    fn is_lost(&self) -> bool {
        self.is_lost
    }

    fn camera(&self) -> Option<CameraId> {
        self.camera
    }

    fn bearing(&self) -> Option<Bearing> {
        self.bearing
    }

    fn position(&self) -> Option<Vec2> {
        self.ball
    }

    fn confidence(&self) -> f32 {
        self.confidence
    }
}

impl Goal for Scene {
    fn is_complete(&self) -> bool {
        self.goal_is_complete
    }

    fn is_found(&self) -> bool {
        self.goal.is_some()
    }

    fn across(&self) -> Vec2 {
        Vec2::Y
    }

    fn gap(&self) -> Option<f32> {
        None
    }

    fn position(&self) -> Option<Vec2> {
        self.goal
    }

    fn restart_search(&mut self) {}
}

impl Place for Scene {
    fn pose(&self) -> Option<Pose2> {
        self.place
    }

    fn posts(&self) -> Option<[Vec2; 2]> {
        None
    }

    fn field(&self) -> &'static FieldDimensions {
        &FIELD
    }
}

impl Robots for Scene {
    fn place(&self, index: usize) -> Option<PositionEstimate> {
        let position = self.robot.filter(|_| index == 0)?;
        Some(PositionEstimate { position, covariance: uncertainty::round(0.1) })
    }
}

impl Carpet for Scene {
    fn shows(&self, _camera: Option<&Camera>, at: Vec2) -> bool {
        at.x <= self.carpet_ahead
    }
}

impl Eye for Scene {
    fn camera(&self) -> Option<&Camera> {
        None
    }
}

#[cfg(feature = "referee")]
impl Whereabouts for Scene {
    fn pose(&self) -> Option<Pose2> {
        self.place
    }

    fn covariance(&self) -> Mat3 {
        Mat3::from_diagonal(Vec3::new(0.01, 0.01, 0.005))
    }
}

impl Odometer for Scene {
    fn pose(&self) -> Pose2 {
        self.walked
    }

    fn is_fresh(&self) -> bool {
        true
    }
}

impl Falls for Scene {
    fn state(&self) -> FallState {
        self.fall
    }

    fn is_down(&self) -> bool {
        self.fall != FallState::Upright
    }
}

impl Health for Scene {
    fn fault(&self) -> Option<Fault> {
        self.fault
    }

    fn sense_fault(&self) -> Option<Fault> {
        None
    }

    fn must_stop(&self) -> bool {
        self.must_stop
    }
}

/// Legs that note the last request and do not walk.
#[derive(Debug)]
pub(crate) struct Feet {
    pub(crate) request: Request,
    pub(crate) kick: Option<Side>,
    pub(crate) is_still: bool,
}

#[component(writers = first)]
impl Feet {
    pub(crate) const fn new() -> Self {
        Self { request: Request::Stand, kick: None, is_still: false }
    }
}

impl Legs for Feet {
    fn stand(&mut self) {
        self.request = Request::Stand;
    }

    fn go(&mut self, forward: f32, turn: f32) {
        self.request = Request::Straight { forward, turn };
    }

    fn turn(&mut self, speed: f32) {
        self.request = Request::Turn(speed);
    }

    fn step_with(&mut self, velocity: Velocity) {
        self.request = Request::Step(velocity);
    }

    fn kick(&mut self, foot: Side) {
        self.kick = Some(foot);
    }

    fn is_still(&self) -> bool {
        self.is_still
    }
}
