//! What stands near the ball.

use glam::Vec2;
use heapless::Vec;

/// The radius of a ball with what its way may be off, m.
const BALL: f32 = 0.06;
/// The radius that the robot needs where it stands to kick, m: its shoulders, or its feet with the steps that lead there.
const BODY: f32 = 0.15;
/// What stands farther from the ball than this is not in its way, m: it may be elsewhere by then.
const NEAR: f32 = 0.8;

/// What is round and stands on the carpet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Obstacle {
    /// Its middle, m, ground frame.
    pub(super) at: Vec2,
    /// m.
    pub(super) radius: f32,
}

/// Two posts and all robots that are remembered.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Obstacles(pub(super) Vec<Obstacle, 6>);

impl Obstacles {
    /// Whether the robot can stand at a place, m, ground frame.
    pub(super) fn lets_stand(&self, place: Vec2) -> bool {
        self.0.iter().all(|obstacle| obstacle.at.distance(place) > obstacle.radius + BODY)
    }

    /// Whether a ball can be kicked that way. What touches it from behind lets it go.
    pub(super) fn lets_pass(&self, ball: Vec2, way: Vec2) -> bool {
        let ahead = way.normalize_or_zero();
        self.0.iter().all(|obstacle| {
            let off = obstacle.at - ball;
            let before = (0.0..NEAR).contains(&off.dot(ahead)) && off.dot(ahead) < way.length();
            !before || libm::fabsf(off.perp_dot(ahead)) > obstacle.radius + BALL
        })
    }
}
