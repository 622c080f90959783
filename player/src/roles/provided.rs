//! Components that provide the roles.

use bica_motion::fall::FallState;
use bica_motion::health::Fault;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use bica_motion::walk::Velocity;
use glam::Vec2;

use super::{Ball, Falls, Goal, Health, Legs, Odometer, Place};
use crate::input::HealthMonitor;
use crate::motion::Body;
use crate::perception::{BallDetector, Bearing, FallDetector, GoalDetector, Localization, Odometry};

/// Implements a role by the component's own functions of the same names.
macro_rules! provide {
    ($role:ident by $component:ident { $(&mut $change:ident($($argument:ident: $kind:ty),*);)* $($name:ident -> $result:ty;)* }) => {
        impl $role for $component {
            $(
                #[inline]
                fn $change(&mut self $(, $argument: $kind)*) {
                    Self::$change(self $(, $argument)*);
                }
            )*
            $(
                #[inline]
                fn $name(&self) -> $result {
                    Self::$name(self)
                }
            )*
        }
    };
}

impl Ball for BallDetector {
    #[inline]
    fn is_looking(&self) -> bool {
        Self::is_looking(self)
    }

    #[inline]
    fn is_confirmed(&self) -> bool {
        Self::is_confirmed(self)
    }

    #[inline]
    fn is_lost(&self) -> bool {
        Self::is_lost(self)
    }

    #[inline]
    fn camera(&self) -> Option<CameraId> {
        self.seen().map(|seen| seen.camera)
    }

    #[inline]
    fn bearing(&self) -> Option<Bearing> {
        Self::bearing(self)
    }

    #[inline]
    fn position(&self) -> Option<Vec2> {
        Self::position(self)
    }

    #[inline]
    fn confidence(&self) -> f32 {
        self.memory().confidence()
    }
}

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
