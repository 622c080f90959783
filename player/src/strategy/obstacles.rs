//! Obstacles near the ball.

use glam::Vec2;
use heapless::Vec;

/// Radius of the ball plus the uncertainty of its path, m.
const BALL_RADIUS: f32 = 0.06;
/// Radius of the free area that the robot needs for a kick, m: its shoulders, or its feet with the steps to the ball.
const BODY_RADIUS: f32 = 0.15;
/// Maximum distance of an obstacle from the ball, m; farther robots will have moved until then.
const NEAR: f32 = 0.8;

/// Circular obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Obstacle {
    /// Centre in the ground frame, m.
    pub(super) at: Vec2,
    /// Radius, m.
    pub(super) radius: f32,
}

/// Returns two goal posts and all remembered robots.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Obstacles(pub(super) Vec<Obstacle, 6>);

impl Obstacles {
    /// Whether the robot can stand at a position in the ground frame, m.
    pub(super) fn allow_stand(&self, place: Vec2) -> bool {
        self.0.iter().all(|obstacle| obstacle.at.distance(place) > obstacle.radius + BODY_RADIUS)
    }

    /// Whether a ball can be kicked along the vector `path`, m. Obstacles behind the ball and beyond the end of the path
    /// have no effect.
    pub(super) fn allow_kick(&self, ball: Vec2, path: Vec2) -> bool {
        let ahead = path.normalize_or_zero();
        self.0.iter().all(|obstacle| {
            let off = obstacle.at - ball;
            let before = (0.0..NEAR).contains(&off.dot(ahead)) && off.dot(ahead) < path.length();
            !before || libm::fabsf(off.perp_dot(ahead)) > obstacle.radius + BALL_RADIUS
        })
    }
}
