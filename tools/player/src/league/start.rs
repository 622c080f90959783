//! Start of a game.

use bica_field::SSIM_2026;
use bica_motion::pose::Pose2;
use glam::Vec2;

/// Distance of the ball from the middle of the goal, m.
const FROM_GOAL: [f32; 2] = [3.0, 8.0];
/// Largest angle between the goal's axis and the direction from the goal to the ball, on either side, rad.
const ASIDE: f32 = 1.0;
/// Distance of the robot from the ball, m.
const FROM_BALL: [f32; 2] = [1.0, 4.0];

/// Start of a game, field frame, with the attacked goal at positive x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Start {
    /// Pose of the robot.
    pub(crate) robot: Pose2,
    /// Position of the ball, m.
    pub(crate) ball: Vec2,
}

impl Start {
    /// Draws a start from a seed: the ball 3 to 8 m from the goal, the robot 1 to 4 m from the ball, on the field, with
    /// any heading.
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Random(seed);
        let mut between = |[low, high]: [f32; 2]| low + (high - low) * random.share();
        let corner = SSIM_2026.field_corner();
        let goal = Vec2::new(corner.x, 0.0);
        let ball = goal - between(FROM_GOAL) * Vec2::from_angle(between([-ASIDE, ASIDE]));
        loop {
            let turn = [-core::f32::consts::PI, core::f32::consts::PI];
            let position = ball + between(FROM_BALL) * Vec2::from_angle(between(turn));
            let robot = Pose2 { position, heading: between(turn) };
            if position.abs().cmplt(corner - 1.0).all() {
                return Self { robot, ball };
            }
        }
    }
}

/// `SplitMix64` (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    /// Returns a number from 0 to 1.
    const fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 40) as f32 / (1 << 24) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_seed_has_its_start_within_the_distances() {
        let goal = Vec2::new(SSIM_2026.field_corner().x, 0.0);
        for seed in 0..200 {
            let Start { robot, ball } = Start::new(seed);
            assert_eq!(Start::new(seed), Start { robot, ball });
            assert_ne!(Start::new(seed + 1).ball, ball);
            assert!((2.99..8.01).contains(&ball.distance(goal)), "{seed}: {ball}");
            assert!((0.99..4.01).contains(&robot.position.distance(ball)), "{seed}: {robot:?}");
            assert!(robot.position.x < goal.x - 0.9);
        }
    }
}
