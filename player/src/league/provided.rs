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
use crate::roles::{Ball, Carpet, Eye, Game, Goal, Place, Robots, Views, provide};

provide!(Ball by BallDetector {
    is_looking -> bool;
    is_confirmed -> bool;
    is_lost -> bool;
    camera -> Option<CameraId>;
    bearing -> Option<Bearing>;
    position -> Option<Vec2>;
    confidence -> f32;
});

provide!(Goal by GoalDetector {
    &mut restart_search();
    is_complete -> bool;
    is_found -> bool;
    across -> Vec2;
    gap -> Option<f32>;
    position -> Option<Vec2>;
});

provide!(Place by Localization {
    pose -> Option<Pose2>;
    posts -> Option<[Vec2; 2]>;
    field -> &'static FieldDimensions;
});

provide!(Robots by RobotDetector {
    place(index: usize) -> Option<PositionEstimate>;
});

provide!(Views by CameraInput {
    count -> u32;
    has_image -> bool;
    glimpse -> Option<Glimpse>;
});

provide!(Game by GameState {
    playing -> bool;
});

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
