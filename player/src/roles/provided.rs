//! Components that provide the roles.

use bica_field::FieldDimensions;
use bica_motion::fall::FallState;
use bica_motion::health::{Fault, Glimpse};
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_motion::walk::Velocity;
use bica_vision::memory::PositionEstimate;
use bica_vision::projection::Camera;
#[cfg(feature = "referee")]
use glam::Mat3;
use glam::Vec2;

use super::{Ball, Carpet, Eye, Falls, Game, Goal, Health, Legs, Odometer, Place, Robots, Views};
#[cfg(feature = "referee")]
use super::{Ears, Whereabouts};
use crate::input::{CameraInput, GameState, HealthMonitor};
use crate::motion::Body;
use crate::perception::{
    BallDetector, Bearing, CameraPose, FallDetector, FieldBoundary, GoalDetector, Localization, Odometry, RobotDetector,
};
#[cfg(feature = "referee")]
use crate::referee::{FieldPose, Whistle};

/// Implements a role by the component's own functions of the same names.
macro_rules! provide {
    ($role:ident by $component:ident { $(&mut $change:ident($($argument:ident: $kind:ty),*);)* $($name:ident$(($asked:ident: $of:ty))? -> $result:ty;)* }) => {
        impl $role for $component {
            $(
                #[inline]
                fn $change(&mut self $(, $argument: $kind)*) {
                    Self::$change(self $(, $argument)*);
                }
            )*
            $(
                #[inline]
                fn $name(&self $(, $asked: $of)?) -> $result {
                    Self::$name(self $(, $asked)?)
                }
            )*
        }
    };
}

/// Implements the roles that the senses of a league provide by functions of the same names.
macro_rules! provide_senses {
    () => {
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
    };
}

#[cfg(feature = "league")]
pub(crate) use {provide, provide_senses};

provide_senses!();

impl Carpet for FieldBoundary {
    #[inline]
    fn shows(&self, camera: Option<&Camera>, at: Vec2) -> bool {
        camera.is_some_and(|camera| self.is_on_field(camera, at))
    }
}

impl Eye for CameraPose {
    #[inline]
    fn camera(&self) -> Option<&Camera> {
        Self::camera(self)
    }
}

#[cfg(feature = "referee")]
provide!(Whereabouts by FieldPose {
    pose -> Option<Pose2>;
    covariance -> Mat3;
});

#[cfg(feature = "referee")]
provide!(Ears by Whistle {
    heard -> bool;
});

provide!(Odometer by Odometry {
    pose -> Pose2;
    is_fresh -> bool;
});

provide!(Legs by Body {
    &mut stand();
    &mut go(forward: f32, turn: f32);
    &mut turn(speed: f32);
    &mut step_with(velocity: Velocity);
    &mut kick(foot: Side);
    is_still -> bool;
});

provide!(Falls by FallDetector {
    state -> FallState;
    is_down -> bool;
});

provide!(Health by HealthMonitor {
    fault -> Option<Fault>;
    sense_fault -> Option<Fault>;
    must_stop -> bool;
});
