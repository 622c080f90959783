//! A shoe that pushes and kicks the ball.

use bica_field::FIELD;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};
use libm::sqrtf;

use super::ball::{Ball, Surface};

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// How high a shoe is: the plastic around a NAO's foot, m (estimated from photographs).
const HEIGHT: f32 = 0.05;
/// Share of the closing speed with which a ball comes off a shoe: our estimate for hard plastic on a rubber ball.
const BOUNCE: f32 = 0.5;
/// Share of the sliding speed that a ball loses at a shoe.
const GRIP: f32 = 0.1;
/// The most that a ball is moved out of a shoe in one sub-step, m: a shoe that comes down on it squeezes it out.
const MOST_PUSH: f32 = 0.005;

/// The sole's corners, field frame, m.
type Outline = [Vec3; Nao::DIMENSIONS.sole_outline.len()];

/// A shoe on its way through one cycle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootContact {
    from: Outline,
    to: Outline,
    dt: f32,
}

impl FootContact {
    /// A shoe whose sole goes from one pose in the field frame to another in `dt` s.
    pub(crate) fn new(side: Side, from: &Affine3A, to: &Affine3A, dt: f32) -> Self {
        Self { from: outline(side, from), to: outline(side, to), dt }
    }

    /// Whether the ball is near enough to be met at all.
    pub(crate) fn is_near(&self, ball: Vec2) -> bool {
        self.from.iter().chain(&self.to).any(|corner| corner.truncate().distance_squared(ball) < 0.15 * 0.15)
    }

    /// Moves the ball out of the shoe's way at `part` (0 to 1) of its way. Says whether they touched.
    pub(crate) fn push(&self, ball: &mut Ball, part: f32) -> bool {
        let Some(surface) = self.surface(ball.position, part) else { return false };
        ball.meet(&surface);
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
        let radius = reach(mix(&corners).z)?;
        let out = if inside { nearest.point - ball } else { ball - nearest.point };
        let depth = if inside { radius + nearest.distance } else { radius - nearest.distance };
        let velocity = (mix(&self.to) - mix(&self.from)).truncate() / self.dt;
        let normal = out.try_normalize()?;
        let pushed = depth.min(MOST_PUSH);
        (depth > 0.0).then_some(Surface { normal, depth: pushed, velocity, bounce: BOUNCE, grip: GRIP })
    }
}

/// The place on a sole's edge nearest to the ball.
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

/// The radius of the ball where a shoe with its sole at `sole` over the ground meets it; `None` if it passes over.
fn reach(sole: f32) -> Option<f32> {
    let over_middle = (sole - BALL_RADIUS).max(0.0).max(BALL_RADIUS - sole - HEIGHT);
    (over_middle < BALL_RADIUS).then(|| sqrtf(BALL_RADIUS * BALL_RADIUS - over_middle * over_middle))
}

/// The corners of a sole in the field frame, counter-clockwise seen from above.
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

    /// Moves a shoe over the ball's place in cycles of 10 ms and sub-steps of 1 ms.
    fn kick(side: Side, speed: f32, height: f32) -> Ball {
        let mut ball = Ball::at(Vec2::new(0.3, 0.0), 1e-6);
        for cycle in 0..60 {
            let x = |cycle| speed * 0.01 * cycle as f32;
            let shoe = FootContact::new(side, &at(x(cycle), 0.0, height), &at(x(cycle + 1), 0.0, height), 0.01);
            for step in 1..=10 {
                ball.roll(0.001);
                shoe.push(&mut ball, step as f32 / 10.0);
            }
        }
        ball
    }

    #[test]
    fn a_kicked_ball_leaves_with_one_and_a_half_times_the_foot_s_speed() {
        for side in Side::BOTH {
            let ball = kick(side, 1.2, 0.01);
            assert!((ball.velocity.length() - 1.8).abs() < 0.01, "{}", ball.velocity);
        }
    }

    #[test]
    fn a_fast_foot_does_not_pass_through() {
        for speed in [0.05, 0.5, 2.0, 4.0] {
            let ball = kick(Side::Right, speed, 0.02);
            assert!(ball.position.x > speed * 0.6 + 0.1, "{speed}: {}", ball.position);
        }
    }

    #[test]
    fn a_foot_lifted_over_the_ball_leaves_it_alone() {
        assert_eq!(kick(Side::Left, 1.0, 0.07), Ball::at(Vec2::new(0.3, 0.0), 1e-6));
        assert_ne!(kick(Side::Left, 1.0, 0.05), Ball::at(Vec2::new(0.3, 0.0), 1e-6));
    }

    #[test]
    fn a_ball_that_rolls_against_a_standing_shoe_bounces_and_never_gains() {
        let mut random = Random::new(9, Stream::Start);
        let shoe = FootContact::new(Side::Left, &at(0.0, 0.0, 0.0), &at(0.0, 0.0, 0.0), 0.01);
        for _ in 0..500 {
            let angle = random.between(-3.0, 3.0);
            let direction = bica_motion::pose::rotate(Vec2::X, angle);
            let mut ball = Ball { velocity: -2.0 * direction, ..Ball::at(0.25 * direction, 0.3) };
            for _ in 0..200 {
                let before = ball.velocity.length();
                ball.roll(0.001);
                shoe.push(&mut ball, 1.0);
                assert!(ball.velocity.length() <= before * 1.000_01);
            }
            assert!(ball.position.length() > 0.1, "{angle}: {}", ball.position);
        }
    }
}
