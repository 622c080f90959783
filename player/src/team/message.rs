//! What a robot sends to the other players of its team.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use glam::Vec2;

use crate::referee::Identity;

/// Part of a player in the game.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// Does not play: it lies, is penalized, or does not know its pose.
    #[default]
    Absent,
    /// Plays the ball.
    Striker,
    /// Follows the striker, ready to take the ball over.
    Supporter,
    /// Stands between the ball and the own goal.
    Defender,
    /// Stays before the own goal.
    Goalkeeper,
}

/// What a player does now.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Intention {
    /// Stands, by the rules or after a fall.
    #[default]
    Stand,
    /// Searches for the ball.
    Search,
    /// Walks to the ball or plays it.
    Play,
    /// Walks to a position, or holds it.
    Position,
}

/// The ball, as a player knows it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SeenBall {
    /// Position, m, field frame.
    pub at: [f32; 2],
    /// Time since it was seen, s; 0 to [`TeamMessage::OLDEST_BALL`].
    pub age: f32,
    /// Standard deviation of the position, m; above 0.
    pub error: f32,
}

/// Covariance of a pose: the upper half of a symmetric matrix with a row and a column for x, y, m, and heading, rad.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseCovariance {
    /// Variances of x, y and heading, m² and rad².
    pub variances: [f32; 3],
    /// Covariances of x and y, x and heading, y and heading.
    pub covariances: [f32; 3],
}

/// Message of a player to its team. The field frame has x towards the attacked goal, from the centre.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TeamMessage {
    /// Sender.
    pub from: Identity,
    /// Time on the sender's clock, ms. Clocks of two robots have nothing in common.
    pub time_ms: u32,
    /// Pose in the field frame: x and y, m, and heading, rad.
    pub pose: [f32; 3],
    /// Covariance of the pose.
    pub covariance: PoseCovariance,
    /// The ball; `None` if it was not seen for [`TeamMessage::OLDEST_BALL`].
    pub ball: Option<SeenBall>,
    /// What the sender does.
    pub intention: Intention,
    /// Part of the sender.
    pub role: Role,
    /// Number of the newest claim to the part of the striker that the sender knows, its own included.
    pub claim: u16,
    /// Time that the sender would take to the ball, s; `None` if the ball is not known.
    pub time_to_ball: Option<f32>,
    /// Longest time to the sender's next message, s.
    pub interval: f32,
}

impl TeamMessage {
    /// Age from which on a ball is not sent, s.
    pub const OLDEST_BALL: f32 = 10.0;
    /// Largest coordinate, m.
    pub const FAR: f32 = 20.0;
    /// Longest time to the ball, and to the next message, s.
    pub const LONG: f32 = 600.0;

    /// Pose in the field frame.
    #[must_use]
    pub const fn pose(&self) -> Pose2 {
        let [x, y, heading] = self.pose;
        Pose2 { position: Vec2::new(x, y), heading }
    }
}

/// A message of another player of the team that has arrived.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heard {
    /// Its content; the sender belongs to the own team.
    pub message: TeamMessage,
    /// Time of its arrival on the clock of the world, µs.
    pub at_us: u64,
}
