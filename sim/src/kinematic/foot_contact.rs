//! Contact between a moving foot and the ball.

use bica_motion::model::{Nao, RobotModel};
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};
use libm::sqrtf;

use super::ball::{Ball, Surface};
use crate::field::BALL_RADIUS;

/// Height of the foot's shell, m (estimated from photographs).
const HEIGHT: f32 = 0.05;
/// Coefficient of restitution: our estimate for a rubber ball on hard plastic.
const RESTITUTION: f32 = 0.5;
/// Fraction of the relative tangential speed that the ball loses on contact (our estimate).
const TANGENTIAL_LOSS: f32 = 0.1;
/// Maximum displacement of the ball per sub-step, m: a foot that is set down on the ball squeezes it out gradually.
const MAX_PUSH: f32 = 0.005;

/// Corners of a sole, field frame, m.
type Outline = [Vec3; Nao::DIMENSIONS.sole_outline.len()];

/// A foot during one control cycle: the outlines of its sole at the start and at the end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootContact {
    from: Outline,
    to: Outline,
    dt: f32,
}

impl FootContact {
    /// Returns a foot whose sole moves from one pose to another in `dt` s. Field frame.
    pub(crate) fn new(side: Side, from: &Affine3A, to: &Affine3A, dt: f32) -> Self {
        Self { from: outline(side, from), to: outline(side, to), dt }
    }

    /// Returns whether contact is possible: a corner comes within 0.15 m of the ball.
    pub(crate) fn is_near(&self, ball: Vec2) -> bool {
        self.from.iter().chain(&self.to).any(|corner| corner.truncate().distance_squared(ball) < 0.15 * 0.15)
    }

    /// Resolves the contact with the ball at the fraction `part` (0 to 1) of the motion. Returns whether there was one.
    pub(crate) fn push(&self, ball: &mut Ball, part: f32) -> bool {
        let Some(surface) = self.surface(ball.position, part) else { return false };
        ball.collide(&surface);
        true
    }

    fn surface(&self, ball: Vec2, part: f32) -> Option<Surface> {
        let corners: Outline = core::array::from_fn(|i| self.from[i].lerp(self.to[i], part));
        let mut nearest = Edge { distance: f32::INFINITY, point: Vec2::ZERO, index: 0, t: 0.0 };
        let mut inside = true;
        for index in 0..corners.len() {
            let (a, b) = (corners[index].truncate(), corners[(index + 1) % corners.len()].truncate());
            inside &= (b - a).perp_dot(ball - a) >= 0.0;
            let edge = Edge::new(index, a, b, ball);
            if edge.distance < nearest.distance {
                nearest = edge;
            }
        }
        let mix = |ends: &Outline| ends[nearest.index].lerp(ends[(nearest.index + 1) % ends.len()], nearest.t);
        let radius = contact_radius(mix(&corners).z)?;
        let outward = if inside { nearest.point - ball } else { ball - nearest.point };
        let depth = if inside { radius + nearest.distance } else { radius - nearest.distance };
        let velocity = (mix(&self.to) - mix(&self.from)).truncate() / self.dt;
        let normal = outward.try_normalize()?;
        let pushed = depth.min(MAX_PUSH);
        (depth > 0.0).then_some(Surface {
            normal,
            depth: pushed,
            velocity,
            restitution: RESTITUTION,
            tangential_loss: TANGENTIAL_LOSS,
        })
    }
}

/// The point of a sole's edge nearest to the ball.
struct Edge {
    distance: f32,
    point: Vec2,
    index: usize,
    t: f32,
}

impl Edge {
    fn new(index: usize, a: Vec2, b: Vec2, ball: Vec2) -> Self {
        let along = b - a;
        let t = ((ball - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let point = a + t * along;
        Self { distance: point.distance(ball), point, index, t }
    }
}

/// Returns the largest radius of the ball between the heights of sole and instep, where `sole` is the height of the sole, m;
/// `None` if the foot passes over the ball.
fn contact_radius(sole: f32) -> Option<f32> {
    let from_centre = (sole - BALL_RADIUS).max(0.0).max(BALL_RADIUS - sole - HEIGHT);
    (from_centre < BALL_RADIUS).then(|| sqrtf(BALL_RADIUS * BALL_RADIUS - from_centre * from_centre))
}

/// Returns the corners of a sole in the field frame, counter-clockwise seen from above.
pub(crate) fn outline(side: Side, sole: &Affine3A) -> Outline {
    core::array::from_fn(|i| {
        let corner = match side {
            Side::Left => Nao::DIMENSIONS.sole_outline[i],
            Side::Right => {
                Nao::DIMENSIONS.sole_outline[Nao::DIMENSIONS.sole_outline.len() - 1 - i] * Vec2::new(1.0, -1.0)
            }
        };
        sole.transform_point3(corner.extend(0.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, Stream};

    fn at(x: f32, y: f32, z: f32) -> Affine3A {
        Affine3A::from_translation(Vec3::new(x, y, z))
    }

    /// Moves a foot through the place of the ball in cycles of 10 ms and sub-steps of 1 ms.
    fn kick(side: Side, speed: f32, height: f32) -> Ball {
        let mut ball = Ball::at(Vec2::new(0.3, 0.0), 1e-6);
        for cycle in 0..60 {
            let x = |cycle| speed * 0.01 * cycle as f32;
            let foot = FootContact::new(side, &at(x(cycle), 0.0, height), &at(x(cycle + 1), 0.0, height), 0.01);
            for step in 1..=10 {
                ball.roll(0.001);
                foot.push(&mut ball, step as f32 / 10.0);
            }
        }
        ball
    }

    #[test]
    fn ball_speed_is_foot_speed_times_one_plus_restitution() {
        for side in Side::BOTH {
            let ball = kick(side, 1.2, 0.01);
            assert!((ball.velocity.length() - 1.8).abs() < 0.01, "{}", ball.velocity);
        }
    }

    #[test]
    fn foot_at_any_speed_pushes_ball_ahead() {
        for speed in [0.05, 0.5, 2.0, 4.0] {
            let ball = kick(Side::Right, speed, 0.02);
            let rolled = ball.position.x - 0.3;
            assert!(ball.position.x > speed * 0.6 + 0.1, "{speed} m/s: {}", ball.position);
            assert!(rolled < 1.5 * speed * 0.6 + 0.01, "{speed} m/s: {}", ball.position);
        }
    }

    #[test]
    fn foot_above_ball_does_not_touch_it() {
        assert_eq!(kick(Side::Left, 1.0, 0.07), Ball::at(Vec2::new(0.3, 0.0), 1e-6));
        assert_ne!(kick(Side::Left, 1.0, 0.05), Ball::at(Vec2::new(0.3, 0.0), 1e-6));
    }

    #[test]
    fn ball_bounces_off_standing_foot_without_gain() {
        let mut random = Random::new(9, Stream::Start);
        let foot = FootContact::new(Side::Left, &at(0.0, 0.0, 0.0), &at(0.0, 0.0, 0.0), 0.01);
        for _ in 0..500 {
            let angle = random.between(-3.0, 3.0);
            let direction = bica_motion::pose::rotate(Vec2::X, angle);
            let mut ball = Ball { velocity: -2.0 * direction, ..Ball::at(0.25 * direction, 0.3) };
            for _ in 0..200 {
                let before = ball.velocity.length();
                ball.roll(0.001);
                foot.push(&mut ball, 1.0);
                assert!(ball.velocity.length() <= before * 1.000_01);
            }
            assert!(ball.position.length() > 0.1, "{angle}: {}", ball.position);
        }
    }
}
