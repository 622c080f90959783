//! Memory of a static object.

use bica_body::random::Random;
use bica_motion::pose::Pose2;
use bica_vision::memory::Memory;
use bica_vision::uncertainty::{self, Covariance, largest};
use glam::Vec2;
use proptest::prelude::*;

use super::noise::{off_by, spread};

fn sharp() -> Covariance {
    uncertainty::round(0.01)
}

fn motion() -> impl Strategy<Value = Pose2> {
    (-0.1_f32..0.1, -0.1_f32..0.1, -0.3_f32..0.3).prop_map(|(x, y, heading)| Pose2::new(x, y, heading))
}

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(f32::MAX), Just(-1.0_f32), Just(0.0_f32), -3.0_f32..3.0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn remembered_position_is_fixed_in_the_world(
        x in -3.0_f32..3.0, y in -3.0_f32..3.0, motions in prop::collection::vec(motion(), 0..20),
    ) {
        let mut memory = Memory::new(60.0);
        memory.see(Vec2::new(x, y), &sharp(), 1.0);
        let (mut robot, mut before) = (Pose2::ORIGIN, 0.0);
        for motion in &motions {
            robot = robot * *motion;
            memory.advance(*motion, 0.01);
            let spread = largest(&memory.estimate().expect("remembered").covariance);
            prop_assert!(spread >= before, "walking reduced the covariance");
            before = spread;
        }
        let place = robot.place(memory.position().expect("remembered"));
        prop_assert!(place.distance(Vec2::new(x, y)) < 1e-4, "{place}");
        prop_assert!((memory.age().expect("remembered") - 0.01 * motions.len() as f32).abs() < 1e-4);
    }

    #[test]
    fn memory_is_finite_for_any_input(
        half_life in number(),
        spread in prop::array::uniform4(number()),
        steps in prop::collection::vec((number(), number(), number(), number(), any::<bool>()), 0..40),
    ) {
        let mut memory = Memory::new(half_life);
        for (a, b, c, d, see) in steps {
            let covariance = Covariance::from_cols_array(&spread) * c;
            if see { memory.see(Vec2::new(a, b), &covariance, d) } else { memory.advance(Pose2::new(a, b, c), d) }
            if let Some(place) = memory.estimate() {
                prop_assert!(place.position.is_finite() && place.covariance.is_finite());
                prop_assert!(memory.age().is_some_and(f32::is_finite));
            }
            prop_assert!((0.0..=1.0).contains(&memory.confidence()));
        }
    }
}

#[test]
fn near_sightings_are_averaged_and_a_far_one_replaces() {
    let mut memory = Memory::new(5.0);
    let spread = uncertainty::round(0.05);
    for turn in 0..100 {
        let noise = if turn % 2 == 0 { 0.05 } else { -0.05 };
        memory.see(Vec2::new(1.0 + noise, 0.0), &spread, 0.8);
    }
    assert!((memory.position().unwrap().x - 1.0).abs() < 0.03);
    assert!(largest(&memory.estimate().unwrap().covariance) < 0.045);
    memory.see(Vec2::new(-1.0, 2.0), &spread, 0.8);
    assert_eq!(memory.position(), Some(Vec2::new(-1.0, 2.0)));
    for _ in 0..13 {
        memory.miss();
    }
    assert_eq!((memory.position(), memory.age()), (None, None));
}

/// The robot walks in a circle with noisy odometry and sees the object from time to time.
#[test]
fn covariance_matches_the_error_of_the_position() {
    let (mut sum, mut count, mut inside) = (0.0, 0.0, 0.0);
    for seed in 0..200 {
        let mut noise = Random::new(seed, 0_u64);
        let landmark = Vec2::new(noise.between(0.5, 2.5), noise.between(-1.5, 1.5));
        let (mut robot, mut memory) = (Pose2::ORIGIN, Memory::new(60.0));
        for step in 0..300 {
            let truth = Pose2::new(0.006, 0.0, noise.between(-0.03, 0.03));
            robot = robot * truth;
            // The odometry noise is the one that the memory assumes.
            let way = 0.08 * truth.position.length().sqrt();
            let turn = 0.05 * truth.heading.abs().sqrt() * noise.normal();
            let measured = Pose2::new(
                truth.position.x + way * noise.normal(),
                truth.position.y + way * noise.normal(),
                truth.heading + turn,
            );
            memory.advance(measured, 0.033);
            let at = robot.locate(landmark);
            if step % 100 < 10 && (0.3..3.0).contains(&at.length()) && at.x > 0.0 {
                let spread = spread(at);
                memory.see(at + off_by(&mut noise, &spread), &spread, 0.9);
            }
            if let Some(distance) = memory.distance(at, &Covariance::ZERO) {
                sum += distance;
                count += 1.0;
                inside += f32::from(u8::from(distance < 5.99));
            }
        }
    }
    let (mean, inside) = (sum / count, inside / count);
    println!("squared Mahalanobis distance: mean {mean:.2} (2 expected), within 95 %: {inside:.3}");
    assert!((1.2..2.6).contains(&mean), "{mean}");
    assert!(inside > 0.92, "{inside}");
}
