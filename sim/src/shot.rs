//! Shots at the robot's own goal, drawn from a seed.

use core::ops::RangeInclusive;
use core::time::Duration;

use bica_motion::pose::rotate;
use glam::Vec2;

use crate::field::{BALL_RADIUS, CORNER, POST, POST_RADIUS};
use crate::random::{Random, Stream};

/// Distances from the centre of the goal from which balls are kicked, m.
pub const DISTANCES: RangeInclusive<f32> = 2.0..=3.0;
/// Largest angle between the field's long axis and the direction from the centre of the goal to the ball, rad (40°).
pub const MAX_ANGLE: f32 = 0.7;
/// Speeds at which balls are kicked, m/s. The lowest one carries a ball 3 m at the largest rolling resistance.
pub const SPEEDS: RangeInclusive<f32> = 1.6..=2.4;
/// Times for which the ball rests before it is kicked, s.
pub const RESTS: RangeInclusive<f32> = 3.0..=5.0;

/// A ball that rests in front of the own goal, at negative x, and is then kicked at it. Field frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// Position of the resting ball, m.
    pub from: Vec2,
    /// Point of the goal line that the ball is kicked at, m, between the posts by at least the ball's radius.
    pub aim: Vec2,
    /// Speed at the kick, m/s.
    pub speed: f32,
    /// Time for which the ball rests.
    pub rest: Duration,
}

impl Shot {
    /// Draws a shot from a seed: distance, angle, aim, speed and rest are uniform in [`DISTANCES`], ±[`MAX_ANGLE`], the width
    /// of the goal, `speeds` (m/s) and [`RESTS`], and independent. `number` counts the shots with one seed.
    #[must_use]
    pub fn draw(seed: u64, number: u32, speeds: &RangeInclusive<f32>) -> Self {
        let mut random = Random::new(seed ^ (u64::from(number) << 32), Stream::Shots);
        let mut within = |range: &RangeInclusive<f32>| random.between(*range.start(), *range.end());
        let goal = Vec2::new(-CORNER.x, 0.0);
        let distance = within(&DISTANCES);
        let angle = within(&(-MAX_ANGLE..=MAX_ANGLE));
        let room = POST.y - POST_RADIUS - BALL_RADIUS;
        let aim = goal + Vec2::new(0.0, within(&(-room..=room)));
        let speed = within(speeds);
        let rest = Duration::from_secs_f32(within(&RESTS));
        Self { from: goal + rotate(Vec2::X, angle) * distance, aim, speed, rest }
    }

    /// Velocity at the kick, m/s.
    #[must_use]
    pub fn velocity(&self) -> Vec2 {
        self.speed * (self.aim - self.from).normalize_or_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shots() -> impl Iterator<Item = Shot> {
        (0..300).map(|seed| Shot::draw(seed, 0, &SPEEDS))
    }

    #[test]
    fn shots_fill_ranges_that_are_documented() {
        let goal = Vec2::new(-3.0, 0.0);
        let distances: Vec<f32> = shots().map(|shot| shot.from.distance(goal)).collect();
        let aims: Vec<f32> = shots().map(|shot| shot.aim.y).collect();
        let speeds: Vec<f32> = shots().map(|shot| shot.velocity().length()).collect();
        for (values, low, high) in [(distances, 2.0, 3.0), (aims, -0.6175, 0.6175), (speeds, 1.6, 2.4)] {
            let (least, most) = values.iter().fold((f32::MAX, f32::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
            let margin = 0.02 * (high - low);
            assert!(least > low - 1e-4 && least < low + margin, "{least} is not just above {low}");
            assert!(most < high + 1e-4 && most > high - margin, "{most} is not just below {high}");
        }
        assert_ne!(Shot::draw(0, 0, &SPEEDS), Shot::draw(0, 1, &SPEEDS));
    }
}
