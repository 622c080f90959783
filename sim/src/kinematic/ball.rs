//! The ball: it rolls, slows down and bounces. Seen from above; its middle stays one radius over the carpet.

use bica_field::FIELD;
use glam::Vec2;

use crate::obstacle::Obstacle;

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// The ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    /// Middle, m, field frame.
    pub(crate) position: Vec2,
    /// m/s, field frame.
    pub(crate) velocity: Vec2,
    /// How the carpet brakes it, m/s².
    pub(crate) braking: f32,
}

/// A surface that meets the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    /// Unit vector out of it.
    pub(crate) normal: Vec2,
    /// How deep the ball is in it, m.
    pub(crate) depth: f32,
    /// Its own velocity, m/s.
    pub(crate) velocity: Vec2,
    /// Share of the closing speed with which the ball comes off.
    pub(crate) bounce: f32,
    /// Share of the sliding speed that the ball loses.
    pub(crate) grip: f32,
}

impl Ball {
    /// A ball that lies still.
    pub(crate) const fn at(position: Vec2, braking: f32) -> Self {
        Self { position, velocity: Vec2::ZERO, braking }
    }

    /// Rolls for `dt` s under constant braking, exactly.
    pub(crate) fn roll(&mut self, dt: f32) {
        let speed = self.velocity.length();
        if speed == 0.0 {
            return;
        }
        let direction = self.velocity / speed;
        let moving = dt.min(speed / self.braking);
        self.position += direction * (speed - 0.5 * self.braking * moving) * moving;
        let left = speed - self.braking * moving;
        self.velocity = if moving < dt { Vec2::ZERO } else { direction * left };
    }

    /// Comes off a surface that it is in: out of it, and away from it if they were closing in.
    pub(crate) fn meet(&mut self, surface: &Surface) {
        self.position += surface.normal * surface.depth;
        let relative = self.velocity - surface.velocity;
        let closing = relative.dot(surface.normal);
        if closing < 0.0 {
            let sliding = relative - closing * surface.normal;
            self.velocity -= (1.0 + surface.bounce) * closing * surface.normal + surface.grip * sliding;
        }
    }

    /// Comes off an obstacle that stands still, if it is in it.
    pub(crate) fn bounce_off(&mut self, obstacle: &Obstacle) {
        if let Some((normal, depth)) = obstacle.overlap(self.position, BALL_RADIUS) {
            let (bounce, grip) = (obstacle.bounce, obstacle.grip);
            self.meet(&Surface { normal, depth, velocity: Vec2::ZERO, bounce, grip });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::obstacle::GOALS;
    use crate::random::{Random, Stream};

    fn bounce(ball: &mut Ball) {
        for obstacle in &GOALS {
            ball.bounce_off(obstacle);
        }
    }

    #[test]
    fn a_rolling_ball_stops_after_v_squared_over_two_a() {
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
    fn energy_never_grows_off_what_stands_still() {
        let mut random = Random::new(5, Stream::Start);
        for _ in 0..2_000 {
            let position = Vec2::new(random.between(2.6, 3.6), random.between(-1.0, 1.0));
            let velocity = Vec2::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0));
            let mut ball = Ball { velocity, ..Ball::at(position, 0.3) };
            for _ in 0..300 {
                let before = ball.velocity.length();
                ball.roll(0.001);
                bounce(&mut ball);
                assert!(ball.velocity.length() <= before * 1.000_01);
            }
        }
    }

    #[test]
    fn a_ball_bounces_off_a_post_with_its_share_of_the_speed() {
        let mut ball = Ball { velocity: Vec2::new(1.0, 0.0), ..Ball::at(Vec2::new(2.9, 0.7), 0.3) };
        let mut turned = false;
        for _ in 0..200 {
            let before = ball.velocity.x;
            ball.roll(0.001);
            bounce(&mut ball);
            if before > 0.0 && ball.velocity.x < 0.0 {
                turned = true;
                assert!((ball.velocity.x + 0.6 * before).abs() < 1e-3);
                assert!((ball.position.x - (3.05 - 0.05 - BALL_RADIUS)).abs() < 2e-3);
            }
        }
        assert!(turned);
    }

    #[test]
    fn no_ball_passes_through_robots_that_stand_or_lie() {
        let mut random = Random::new(6, Stream::Start);
        let (left, right) = (Vec2::new(0.0, 0.05), Vec2::new(0.0, -0.05));
        for robot in [Obstacle::legs(left, right), Obstacle::lying(left, right + Vec2::new(0.25, 0.0))] {
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
    fn the_net_holds_the_ball() {
        let mut ball = Ball { velocity: Vec2::new(3.0, 0.4), ..Ball::at(Vec2::new(2.5, 0.0), 0.3) };
        for _ in 0..5_000 {
            ball.roll(0.001);
            bounce(&mut ball);
        }
        assert_eq!(ball.velocity, Vec2::ZERO);
        assert!(ball.position.x > 3.2 && ball.position.x < 3.5, "{}", ball.position);
    }
}
