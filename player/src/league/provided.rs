//! Roles that the senses of the league provide.

use bica_field::FieldDimensions;
use bica_motion::health::Glimpse;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_vision::memory::PositionEstimate;
use bica_vision::projection::Camera;
use glam::Vec2;

use super::input::{CameraInput, GameState};
use super::perception::{BallDetector, CameraPose, FieldBoundary, GoalDetector, Localization, RobotDetector};
use crate::perception::Bearing;
use crate::roles::{Ball, Carpet, Eye, Game, Goal, Place, Robots, Views, provide, provide_senses};

provide_senses!();

impl Carpet for FieldBoundary {
    fn shows(&self, _camera: Option<&Camera>, at: Vec2) -> bool {
        self.is_on_field(at)
    }
}

impl Eye for CameraPose {
    fn camera(&self) -> Option<&Camera> {
        None
    }
}
