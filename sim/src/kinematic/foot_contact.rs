//! Contact between a moving foot and the ball.

use bica_motion::model::RobotModel;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};
use libm::sqrtf;

use super::ball::{Ball, Surface};
use crate::field::BALL_RADIUS;

/// Coefficient of restitution: our estimate for a rubber ball on hard plastic.
const RESTITUTION: f32 = 0.5;
/// Fraction of the relative tangential speed that the ball loses on contact (our estimate).
const TANGENTIAL_LOSS: f32 = 0.1;
/// Radius of the ball and the distance that a foot moves in a cycle, with a reserve, m.
const MARGIN: f32 = 0.1;
/// Maximum displacement of the ball per sub-step, m: a foot that is set down on the ball squeezes it out gradually.
const MAX_PUSH: f32 = 0.005;

/// A foot during one control cycle.
#[derive(Clone, Debug)]
pub(crate) struct FootContact {
    /// Corners of the sole at the start and at the end of the cycle, field frame, m.
    corners: Vec<[Vec3; 2]>,
    /// Distance from a corner within which there may be a contact, m.
    reach: f32,
    /// Height of the shell, m.
    height: f32,
    dt: f32,
}

impl FootContact {
    /// Returns a foot whose sole moves from one pose to another in `dt` s. Field frame.
    pub(crate) fn new(model: &'static SimulatedModel, side: Side, from: &Affine3A, to: &Affine3A, dt: f32) -> Self {
        let corners: Vec<_> = outline(model, side, from).zip(outline(model, side, to)).map(|(a, b)| [a, b]).collect();
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let longest = edges.fold(0.0_f32, |longest, (a, b)| longest.max(a[0].distance_squared(b[0])));
        Self { corners, reach: MARGIN + sqrtf(longest) / 2.0, height: model.extents.foot_height, dt }
    }

    /// Returns false only if there is no contact.
    pub(crate) fn is_near(&self, ball: Vec2) -> bool {
        let limit = self.reach * self.reach;
        self.corners.iter().flatten().any(|corner| corner.truncate().distance_squared(ball) < limit)
    }

    /// Resolves the contact with the ball at the fraction `part` (0 to 1) of the motion. Returns whether there was one.
    pub(crate) fn push(&self, ball: &mut Ball, part: f32) -> bool {
        let Some(surface) = self.surface(ball.position, part) else { return false };
        ball.collide(&surface);
        true
    }

    fn surface(&self, ball: Vec2, part: f32) -> Option<Surface> {
        let corner = |index: usize| {
            let [from, to] = self.corners[index % self.corners.len()];
            from.lerp(to, part)
        };
        let mut nearest = Edge { distance: f32::INFINITY, point: Vec2::ZERO, index: 0, t: 0.0 };
        let mut inside = true;
        for index in 0..self.corners.len() {
            let (a, b) = (corner(index).truncate(), corner(index + 1).truncate());
            inside &= (b - a).perp_dot(ball - a) >= 0.0;
            let edge = Edge::new(index, a, b, ball);
            if edge.distance < nearest.distance {
                nearest = edge;
            }
        }
        let Edge { index, t, .. } = nearest;
        let [[a_from, a_to], [b_from, b_to]] = [index, index + 1].map(|i| self.corners[i % self.corners.len()]);
        let radius = contact_radius(corner(index).lerp(corner(index + 1), t).z, self.height)?;
        let outward = if inside { nearest.point - ball } else { ball - nearest.point };
        let depth = if inside { radius + nearest.distance } else { radius - nearest.distance };
        let velocity = (a_to.lerp(b_to, t) - a_from.lerp(b_from, t)).truncate() / self.dt;
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

/// Returns the largest radius of the ball between the heights of sole and instep, where `sole` is the height of the sole and
/// `height` the height of the shell, m; `None` if the foot passes over the ball.
fn contact_radius(sole: f32, height: f32) -> Option<f32> {
    let from_centre = (sole - BALL_RADIUS).max(0.0).max(BALL_RADIUS - sole - height);
    (from_centre < BALL_RADIUS).then(|| sqrtf(BALL_RADIUS * BALL_RADIUS - from_centre * from_centre))
}

/// Returns the corners of a sole in the field frame, counter-clockwise seen from above.
pub(crate) fn outline(model: &'static RobotModel, side: Side, sole: &Affine3A) -> impl Iterator<Item = Vec3> {
    let corners = model.dimensions.sole_outline;
    (0..corners.len()).map(move |i| {
        let corner = match side {
            Side::Left => corners[i],
            Side::Right => corners[corners.len() - 1 - i] * Vec2::new(1.0, -1.0),
        };
        sole.transform_point3(corner.extend(0.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::random::{Random, Stream};

    fn at(x: f32, y: f32, z: f32) -> Affine3A {
        Affine3A::from_translation(Vec3::new(x, y, z))
    }

    /// Moves a foot through the place of the ball in cycles of 10 ms and sub-steps of 1 ms.
    fn kick(side: Side, speed: f32, height: f32) -> Ball {
        let mut ball = Ball::at(Vec2::new(0.3, 0.0), 1e-6);
        for cycle in 0..60 {
            let x = |cycle| speed * 0.01 * cycle as f32;
            let foot =
                FootContact::new(TEST_MODEL, side, &at(x(cycle), 0.0, height), &at(x(cycle + 1), 0.0, height), 0.01);
            for step in 1..=10 {
                ball.roll(0.001);
                foot.push(&mut ball, step as f32 / 10.0);
            }
        }
        ball
    }

    #[test]
    fn ball_speed_follows_foot_speed_and_restitution() {
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
        let foot = FootContact::new(TEST_MODEL, Side::Left, &at(0.0, 0.0, 0.0), &at(0.0, 0.0, 0.0), 0.01);
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
