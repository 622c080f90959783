//! The ball: rolling and bouncing in the plane. Its centre stays one radius above the carpet.

use glam::Vec2;

use crate::field::BALL_RADIUS;
use crate::obstacle::Obstacle;

/// State of the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    /// Centre, m, field frame.
    pub(crate) position: Vec2,
    /// Velocity, m/s, field frame.
    pub(crate) velocity: Vec2,
    /// Deceleration by rolling resistance, m/s².
    pub(crate) rolling_deceleration: f32,
}

/// A surface that touches the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    /// Outward normal, unit vector.
    pub(crate) normal: Vec2,
    /// Penetration depth of the ball, m.
    pub(crate) depth: f32,
    /// Velocity of the surface, m/s.
    pub(crate) velocity: Vec2,
    /// Coefficient of restitution, 0 to 1.
    pub(crate) restitution: f32,
    /// Fraction of the relative tangential speed that the ball loses, 0 to 1.
    pub(crate) tangential_loss: f32,
}

impl Ball {
    /// Returns a ball at rest.
    pub(crate) const fn at(position: Vec2, rolling_deceleration: f32) -> Self {
        Self { position, velocity: Vec2::ZERO, rolling_deceleration }
    }

    /// Rolls for `dt` s under constant deceleration (exact solution).
    pub(crate) fn roll(&mut self, dt: f32) {
        let speed = self.velocity.length();
        if speed == 0.0 {
            return;
        }
        let direction = self.velocity / speed;
        let moving = dt.min(speed / self.rolling_deceleration);
        self.position += direction * (speed - 0.5 * self.rolling_deceleration * moving) * moving;
        let left = speed - self.rolling_deceleration * moving;
        self.velocity = if moving < dt { Vec2::ZERO } else { direction * left };
    }

    /// Resolves a contact: removes the penetration and, if the bodies approach each other, applies restitution and friction.
    pub(crate) fn collide(&mut self, surface: &Surface) {
        self.position += surface.normal * surface.depth;
        let relative = self.velocity - surface.velocity;
        let closing = relative.dot(surface.normal);
        if closing < 0.0 {
            let sliding = relative - closing * surface.normal;
            self.velocity -= (1.0 + surface.restitution) * closing * surface.normal + surface.tangential_loss * sliding;
        }
    }

    /// Resolves a contact with a static obstacle, if there is one.
    pub(crate) fn bounce_off(&mut self, obstacle: &Obstacle) {
        if let Some((normal, depth)) = obstacle.overlap(self.position, BALL_RADIUS) {
            let (restitution, tangential_loss) = (obstacle.restitution, obstacle.tangential_loss);
            self.collide(&Surface { normal, depth, velocity: Vec2::ZERO, restitution, tangential_loss });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::obstacle::GOALS;
    use crate::random::{Random, Stream};
    use bica_motion::pose::Pose2;
    use glam::Affine3A;

    fn bounce_off_goals(ball: &mut Ball) {
        for obstacle in &GOALS {
            ball.bounce_off(obstacle);
        }
    }

    #[test]
    fn rolling_distance_is_v_squared_over_two_a() {
        for speed in [0.1, 0.7, 1.9, 3.5] {
            for dt in [0.001, 0.01, 0.033] {
                let mut ball = Ball { velocity: Vec2::new(0.0, speed), ..Ball::at(Vec2::ZERO, 0.35) };
                for _ in 0..20_000 {
                    ball.roll(dt);
                }
                let expected = speed * speed / (2.0 * 0.35);
                assert_eq!(ball.velocity, Vec2::ZERO);
                assert!((ball.position.y - expected).abs() < 2e-3 * expected, "{} {expected}", ball.position.y);
            }
        }
    }

    #[test]
    fn contact_with_static_obstacle_never_adds_energy() {
        let mut random = Random::new(5, Stream::Start);
        for _ in 0..2_000 {
            let position = Vec2::new(random.between(2.6, 3.6), random.between(-1.0, 1.0));
            let velocity = Vec2::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0));
            let mut ball = Ball { velocity, ..Ball::at(position, 0.3) };
            for _ in 0..300 {
                let before = ball.velocity.length();
                ball.roll(0.001);
                bounce_off_goals(&mut ball);
                assert!(ball.velocity.length() <= before * 1.000_01);
            }
        }
    }

    #[test]
    fn post_returns_normal_speed_times_its_restitution() {
        let mut ball = Ball { velocity: Vec2::new(1.0, 0.0), ..Ball::at(Vec2::new(2.9, 0.7), 0.3) };
        let mut turned = false;
        for _ in 0..200 {
            let before = ball.velocity.x;
            ball.roll(0.001);
            bounce_off_goals(&mut ball);
            if before > 0.0 && ball.velocity.x < 0.0 {
                turned = true;
                assert!((ball.velocity.x + 0.6 * before).abs() < 1e-3);
                assert!((ball.position.x - (3.05 - 0.05 - BALL_RADIUS)).abs() < 2e-3);
            }
        }
        assert!(turned);
    }

    #[test]
    fn no_ball_passes_through_standing_or_lying_robot() {
        let mut random = Random::new(6, Stream::Start);
        let lying = Affine3A::from_rotation_y(core::f32::consts::FRAC_PI_2);
        for robot in [Obstacle::legs(TEST_MODEL, &Pose2::ORIGIN), Obstacle::lying(TEST_MODEL, &lying)] {
            for _ in 0..500 {
                let from = Vec2::new(random.between(-1.0, 1.0), random.between(0.5, 1.0));
                let aim = Vec2::new(random.between(-0.05, 0.05), 0.0) - from;
                let mut ball = Ball { velocity: 3.0 * aim.normalize(), ..Ball::at(from, 0.3) };
                for _ in 0..500 {
                    ball.roll(0.001);
                    ball.bounce_off(&robot);
                    let distance = ball.position.distance(robot.nearest(ball.position));
                    assert!(distance > robot.radius + BALL_RADIUS - 1e-4, "{distance}");
                }
            }
        }
    }

    #[test]
    fn ball_in_goal_rests_at_net() {
        let mut ball = Ball { velocity: Vec2::new(3.0, 0.4), ..Ball::at(Vec2::new(2.5, 0.0), 0.3) };
        for _ in 0..5_000 {
            ball.roll(0.001);
            bounce_off_goals(&mut ball);
        }
        assert_eq!(ball.velocity, Vec2::ZERO);
        assert!(ball.position.x > 3.2 && ball.position.x < 3.5, "{}", ball.position);
    }
}
