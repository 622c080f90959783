//! What the behaviours need of perception and body, without naming the components that provide it.
//!
//! A tree names the providers. A test of a behaviour names components with made-up values.

mod provided;

use bica::prelude::*;
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

use crate::perception::Bearing;
#[cfg(feature = "league")]
pub(crate) use provided::{provide, provide_senses};

/// The ball, as the robot sees and remembers it.
#[role]
pub trait Ball {
    /// Whether the provider looks for the ball.
    fn is_looking(&self) -> bool;

    /// Whether the ball was in the last images.
    fn is_confirmed(&self) -> bool;

    /// Whether the last confirmed sighting is old, or nobody looks for the ball.
    fn is_lost(&self) -> bool;

    /// The camera whose newest image shows the ball.
    fn camera(&self) -> Option<CameraId>;

    /// Bearing of the ball, or else of its remembered position, rad.
    fn bearing(&self) -> Option<Bearing>;

    /// Most probable position of the ball, m, in the ground frame between the feet; `None` if it is not known.
    fn position(&self) -> Option<Vec2>;

    /// Confidence in the remembered position, 0 to 1.
    fn confidence(&self) -> f32;
}

/// The attacked goal, as the robot sees and remembers it.
#[role]
pub trait Goal {
    /// Whether both posts were seen at once since the search was restarted.
    fn is_complete(&self) -> bool;

    /// Whether a part of the goal was seen since the search was restarted.
    fn is_found(&self) -> bool;

    /// Unit vector along the goal line, from the right post to the left one, in the ground frame.
    fn across(&self) -> Vec2;

    /// Middle of the widest gap, m to the left of the middle of the goal; `None` if it is not known.
    fn gap(&self) -> Option<f32>;

    /// Middle of the goal, m, in the ground frame between the feet; `None` if it is not known.
    fn position(&self) -> Option<Vec2>;

    /// Restarts the search: only later sightings count as found.
    fn restart_search(&mut self);
}

/// The place of the robot on the field.
#[role]
pub trait Place {
    /// Pose, m and rad, in the frame of the field; `None` if it is not known.
    fn pose(&self) -> Option<Pose2>;

    /// Left and right post of the attacked goal, m, in the ground frame between the feet; `None` if the pose is not known.
    fn posts(&self) -> Option<[Vec2; 2]>;

    /// The field.
    fn field(&self) -> &'static FieldDimensions;
}

/// The other robots.
#[role]
pub trait Robots {
    /// The position of the robot of an index from 0, m, in the ground frame between the feet of this robot; `None` after the last one,
    /// and if the motion of this robot is not known.
    fn place(&self, index: usize) -> Option<PositionEstimate>;
}

/// The positions of the other robots, m, in the ground frame between the feet of this robot.
pub(crate) fn positions(robots: &impl Robots) -> impl Iterator<Item = Vec2> + '_ {
    (0..).map_while(|index| robots.place(index)).map(|place| place.position)
}

/// The end of the field.
#[role]
pub trait Carpet {
    /// Whether a position in the ground frame between the feet, m, is on the field as far as the robot knows; `camera` took the newest
    /// image.
    fn shows(&self, camera: Option<&Camera>, at: Vec2) -> bool;
}

/// The camera that took the newest image.
#[role]
pub trait Eye {
    /// The camera with its pose in the ground frame; `None` if there was no image for half a second, or the robot gets no images.
    fn camera(&self) -> Option<&Camera>;
}

/// What the cameras take, as images or as what is in view.
#[role]
pub trait Views {
    /// Number of views so far; it identifies the newest one.
    fn count(&self) -> u32;

    /// Whether the newest view can be processed.
    fn has_image(&self) -> bool;

    /// What the health monitor compares of the newest view; `None` if there is no view.
    fn glimpse(&self) -> Option<Glimpse>;
}

/// The game, by what its referee says.
#[role]
pub trait Game {
    /// Whether the robot may play.
    fn playing(&self) -> bool;
}

/// What the robot hears of the referee.
#[cfg(feature = "referee")]
#[role]
pub trait Ears {
    /// Whether the whistle was heard since the last cycle.
    fn heard(&self) -> bool;
}

/// The place of the robot on the field, also between sightings of marks.
#[cfg(feature = "referee")]
#[role]
pub trait Whereabouts {
    /// Pose, m and rad, in the frame of the field; `None` before the robot has localized itself.
    fn pose(&self) -> Option<Pose2>;

    /// Covariance of the pose: x and y, m, and heading, rad.
    fn covariance(&self) -> Mat3;
}

/// The way that the robot has walked.
#[role]
pub trait Odometer {
    /// Pose, m and rad, in the frame of the odometry.
    fn pose(&self) -> Pose2;

    /// Whether the pose is measured at present.
    fn is_fresh(&self) -> bool;
}

/// What carries the robot over the field.
#[role]
pub trait Legs {
    /// Requests to stand with the feet together.
    fn stand(&mut self);

    /// Requests to walk forward, m/s, while turning, rad/s, positive to the left.
    fn go(&mut self, forward: f32, turn: f32);

    /// Requests to turn on the spot, rad/s, positive to the left.
    fn turn(&mut self, speed: f32);

    /// Requests steps in any direction.
    fn step_with(&mut self, velocity: Velocity);

    /// Requests that a foot swings through the ball in its next step; only while stepping in any direction.
    fn kick(&mut self, foot: Side);

    /// Whether the robot stands with both feet together.
    fn is_still(&self) -> bool;
}

/// Whether the robot stands, falls or lies.
#[role]
pub trait Falls {
    /// The state of the body.
    fn state(&self) -> FallState;

    /// Whether the robot falls or lies.
    fn is_down(&self) -> bool;
}

/// Faults of the robot.
#[role]
pub trait Health {
    /// The worst fault.
    fn fault(&self) -> Option<Fault>;

    /// A fault of a sense without which the robot does not walk.
    fn sense_fault(&self) -> Option<Fault>;

    /// Whether a fault ends the current motion.
    fn must_stop(&self) -> bool;
}
