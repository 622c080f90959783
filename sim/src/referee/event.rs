//! Events on the field.

use core::time::Duration;

use bica_motion::fall::Direction;
use bica_motion::side::Side;
use glam::Vec2;

/// An event on the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The whole ball crossed the line of the attacked goal, between the posts.
    Goal,
    /// The whole ball crossed the line of the robot's own goal, between the posts.
    OwnGoal,
    /// A foot touched the ball after 0.5 s or more without contact.
    Touch {
        /// The foot.
        foot: Side,
    },
    /// The ball left a foot at 0.5 m/s or faster.
    Kick {
        /// The foot.
        foot: Side,
        /// The ball's speed, m/s.
        speed: f32,
    },
    /// The whole ball crossed a side line, or a goal line beside the goal.
    BallOut,
    /// The ball was put back into play.
    BallPlaced {
        /// The ball's new position, m, field frame.
        at: Vec2,
    },
    /// The robot lost its balance.
    Fall(Direction),
    /// The robot is on its feet again.
    GotUp,
    /// The robot hit a post, a net or another robot after 0.5 s or more without such contact.
    Collision,
}

/// An event and its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedEvent {
    /// Time since the start of the world.
    pub at: Duration,
    /// The event.
    pub event: Event,
}
