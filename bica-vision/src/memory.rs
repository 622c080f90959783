//! Perceptual memory: where a stimulus is while nobody looks at it.
//!
//! A remembered place moves against the robot's own motion (odometry) and is believed less with time and with the way
//! walked. What it holds is always a number. Cost: 30 ns for each motion or sighting.

use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::exp2f;

/// Below this confidence a place is forgotten.
const FORGOTTEN: f32 = 0.02;
/// The way that halves the confidence in a place, m: odometry is off by a tenth or so.
const HALVING_WAY: f32 = 3.0;
/// The turn that halves it, rad.
const HALVING_TURN: f32 = 6.0;
/// A sighting within this distance, m, plus this part of the range, is the same place seen again.
const SAME: (f32, f32) = (0.15, 0.2);

/// A remembered place on the ground, in the ground frame of the robot as it stands now: m, x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    position: Vec2,
    confidence: f32,
    age: f32,
    half_life: f32,
}

impl Memory {
    /// Nothing remembered yet. Confidence will halve in `half_life` seconds without a sighting; not positive or not a
    /// number: at once.
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { position: Vec2::ZERO, confidence: 0.0, age: 0.0, half_life }
    }

    /// The place, if it is not forgotten.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        (self.confidence >= FORGOTTEN).then_some(self.position)
    }

    /// How much the place is believed, 0 to 1.
    #[must_use]
    pub const fn confidence(&self) -> f32 {
        self.confidence
    }

    /// Seconds since it was last seen. None if nothing is remembered.
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.position().map(|_| self.age)
    }

    /// Forgets the place.
    pub const fn forget(&mut self) {
        *self = Self::new(self.half_life);
    }

    /// Takes in a sighting: m in the robot's ground frame, with a confidence of 0 to 1. Close to the remembered place
    /// both are weighed by their confidence, else the new one stands. What is not a number is not seen.
    pub fn see(&mut self, position: Vec2, confidence: f32) {
        let confidence = confidence.clamp(0.0, 1.0);
        if !position.is_finite() || confidence.is_nan() || confidence < FORGOTTEN {
            return;
        }
        let gate = SAME.0 + SAME.1 * position.length();
        let seen_before = self.position().filter(|old| old.distance(position) <= gate);
        self.position = seen_before.map_or(position, |old| {
            let weight = confidence / (confidence + self.confidence);
            old.lerp(position, weight)
        });
        self.confidence = seen_before.map_or(confidence, |_| confidence.max(self.confidence));
        self.age = 0.0;
    }

    /// It should have been seen and was not: believed half as much.
    pub fn miss(&mut self) {
        self.confidence *= 0.5;
    }

    /// The robot moved by `motion` (its new pose, seen from its old one) and `seconds` went by. A motion that is not
    /// a number counts as none, a time that is not positive as no time.
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        let motion = if is_finite(motion) { motion } else { Pose2::ORIGIN };
        let seconds = if seconds > 0.0 { seconds } else { 0.0 };
        self.position = motion.locate(self.position);
        let by_time = if self.half_life > 0.0 { seconds / self.half_life } else { f32::INFINITY };
        let lives = by_time + motion.position.length() / HALVING_WAY + libm::fabsf(motion.heading) / HALVING_TURN;
        self.confidence *= exp2f(-lives);
        self.age += seconds;
        if !(self.position.is_finite() && self.confidence >= FORGOTTEN && self.age.is_finite()) {
            self.forget();
        }
    }
}

fn is_finite(pose: Pose2) -> bool {
    pose.position.is_finite() && pose.heading.is_finite()
}

#[cfg(test)]
mod tests {
    extern crate std;

    use proptest::prelude::*;

    use super::*;

    fn motion() -> impl Strategy<Value = Pose2> {
        (-0.1_f32..0.1, -0.1_f32..0.1, -0.3_f32..0.3).prop_map(|(x, y, heading)| Pose2::new(x, y, heading))
    }

    fn number() -> impl Strategy<Value = f32> {
        prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(f32::MAX), Just(-1.0_f32), Just(0.0_f32), -3.0_f32..3.0]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn a_place_stays_where_it_is_while_the_robot_moves(
            x in -3.0_f32..3.0, y in -3.0_f32..3.0, motions in prop::collection::vec(motion(), 0..20),
        ) {
            let mut memory = Memory::new(60.0);
            memory.see(Vec2::new(x, y), 1.0);
            let mut robot = Pose2::ORIGIN;
            for motion in &motions {
                robot = robot * *motion;
                memory.advance(*motion, 0.01);
            }
            let place = robot.place(memory.position().expect("remembered"));
            prop_assert!(place.distance(Vec2::new(x, y)) < 1e-4, "{place}");
            prop_assert!((memory.age().expect("remembered") - 0.01 * motions.len() as f32).abs() < 1e-4);
        }

        #[test]
        fn belief_halves_in_a_half_life(half_life in 0.5_f32..20.0, steps in 1_u16..400) {
            let mut memory = Memory::new(half_life);
            memory.see(Vec2::X, 1.0);
            for _ in 0..steps {
                memory.advance(Pose2::ORIGIN, half_life / f32::from(steps));
            }
            prop_assert!((memory.confidence() - 0.5).abs() < 1e-3);
        }

        #[test]
        fn nothing_makes_it_remember_what_is_no_number(
            half_life in number(),
            steps in prop::collection::vec((number(), number(), number(), number(), any::<bool>()), 0..40),
        ) {
            let mut memory = Memory::new(half_life);
            for (a, b, c, d, see) in steps {
                if see { memory.see(Vec2::new(a, b), c) } else { memory.advance(Pose2::new(a, b, c), d) }
                let numbers = [memory.position.x, memory.position.y, memory.age, memory.confidence];
                prop_assert!(numbers.iter().all(|n| n.is_finite()), "{memory:?}");
                prop_assert!((0.0..=1.0).contains(&memory.confidence()));
            }
        }
    }

    #[test]
    fn sightings_of_one_place_are_averaged_and_a_far_one_replaces() {
        let mut memory = Memory::new(5.0);
        for turn in 0..100 {
            let noise = if turn % 2 == 0 { 0.05 } else { -0.05 };
            memory.see(Vec2::new(1.0 + noise, 0.0), 0.8);
        }
        assert!((memory.position().unwrap().x - 1.0).abs() < 0.03);
        memory.see(Vec2::new(-1.0, 2.0), 0.8);
        assert_eq!(memory.position(), Some(Vec2::new(-1.0, 2.0)));
        for _ in 0..10 {
            memory.miss();
        }
        assert_eq!((memory.position(), memory.age()), (None, None));
    }
}
