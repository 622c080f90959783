//! Resting and rolling balls, observed with noise by a walking robot.

use bica_body::random::Random;
use bica_motion::pose::{Pose2, rotate};
use bica_vision::memory::ball::BallMemory;
use bica_vision::uncertainty::{Covariance, largest};
use glam::Vec2;
use proptest::prelude::*;

use super::noise::{off_by, root, spread};

const STEP: f32 = 1.0 / 30.0;

/// Simulated ball and robot on a field.
struct Scene {
    ball: Vec2,
    velocity: Vec2,
    braking: f32,
    robot: Pose2,
    /// Slowly varying part of the errors of sightings, in standard deviations.
    bias: Vec2,
    noise: Random,
    memory: BallMemory,
}

impl Scene {
    fn new(seed: u64) -> Self {
        let mut noise = Random::new(seed, 0_u64);
        let ball = Vec2::new(noise.between(0.3, 1.5), noise.between(-0.6, 0.6));
        let braking = noise.between(0.25, 0.4);
        let memory = BallMemory::new(5.0);
        Self { ball, velocity: Vec2::ZERO, braking, robot: Pose2::ORIGIN, bias: Vec2::ZERO, noise, memory }
    }

    /// True position of the ball in the robot's frame, m.
    fn local(&self) -> Vec2 {
        self.robot.locate(self.ball)
    }

    fn kick(&mut self, slowest: f32) {
        let way = self.noise.between(-1.0, 1.0);
        self.velocity = rotate(Vec2::X, way) * self.noise.between(slowest, 1.5);
    }

    fn roll(&mut self) {
        let speed = self.velocity.length();
        let left = (speed - self.braking * STEP).max(0.0);
        self.ball += 0.5 * (speed + left) * STEP * self.velocity.normalize_or_zero();
        self.velocity = left * self.velocity.normalize_or_zero();
    }

    /// Simulates one image; the robot walks at `speed` m/s. `lasting` is the fraction of the noise that varies slowly.
    fn step(&mut self, speed: f32, lasting: f32) {
        self.roll();
        let motion = Pose2::new(speed * STEP, 0.0, 0.1 * speed * STEP);
        self.robot = self.robot * motion;
        let way = 0.08 * motion.position.length().sqrt();
        let off = Pose2::new(way * self.noise.normal(), way * self.noise.normal(), 0.0);
        self.memory.advance(motion * off, STEP);
        if self.noise.unit() < 0.15 {
            return;
        }
        let (at, new) = (self.local(), Vec2::new(self.noise.normal(), self.noise.normal()));
        // The bias is correlated over about a third of a second.
        self.bias = 0.9 * self.bias + (1.0 - 0.81_f32).sqrt() * new;
        let spread = spread(at);
        let off =
            (1.0 - lasting).sqrt() * off_by(&mut self.noise, &spread) + lasting.sqrt() * (root(&spread) * self.bias);
        self.memory.see(at + off, &spread, 0.8);
    }

    /// Squared Mahalanobis distance of the truth from the estimate.
    fn off(&self) -> f32 {
        let place = self.memory.estimate().expect("just seen");
        let off = self.local() - place.position;
        off.dot(place.covariance.try_inverse().expect("a covariance") * off)
    }
}

fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len() as f32
}

fn share(values: &[f32], is: impl Fn(f32) -> bool) -> f32 {
    values.iter().filter(|value| is(**value)).count() as f32 / values.len() as f32
}

fn median(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values[values.len() / 2]
}

/// Squared Mahalanobis distances over many runs with a ball that is kicked after 2 s.
fn consistency(speed: f32, lasting: f32) -> (Vec<f32>, Vec<f32>) {
    let (mut resting, mut rolling) = (vec![], vec![]);
    for seed in 0..200 {
        let mut scene = Scene::new(seed);
        for step in 0..150 {
            if step == 60 {
                scene.kick(0.4);
            }
            scene.step(speed, lasting);
            match step {
                20..60 => resting.push(scene.off()),
                75..105 if scene.velocity.length() > 0.1 => rolling.push(scene.off()),
                _ => {}
            }
        }
    }
    (resting, rolling)
}

#[test]
fn covariance_matches_the_error_of_the_ball() {
    for (speed, lasting) in [(0.0, 0.0), (0.2, 0.0), (0.0, 0.5), (0.2, 0.5)] {
        for (name, values) in ["resting", "rolling"].into_iter().zip(<[_; 2]>::from(consistency(speed, lasting))) {
            let (mean, inside) = (mean(&values), share(&values, |value| value < 5.99));
            println!(
                "{name}, {speed} m/s, {lasting} of the noise lasts: mean {mean:.2} (2 expected), 95 %: {inside:.3}"
            );
            assert!((0.5..2.4).contains(&mean), "{name} {speed} {lasting}: {mean}");
            assert!(inside > 0.92, "{name} {speed} {lasting}: {inside}");
        }
    }
}

#[test]
fn rolling_and_resting_balls_are_distinguished() {
    for speed in [0.0, 0.2] {
        let (mut resting, mut rolling, mut stopped) = (vec![], vec![], vec![]);
        for seed in 1000..1200 {
            let mut scene = Scene::new(seed);
            let mut still = 0;
            for step in 0..240 {
                if step == 45 {
                    scene.kick(0.5);
                }
                scene.step(speed, 0.5);
                still = if scene.velocity == Vec2::ZERO { still + 1 } else { 0 };
                match step {
                    15..45 => resting.push(scene.memory.rolls()),
                    // From 0.5 s after the kick on, while the ball is fast enough to be classified within some images.
                    60.. if scene.velocity.length() > 0.3 && scene.local().length() < 2.5 => {
                        rolling.push(scene.memory.rolls());
                    }
                    60.. if still > 30 && scene.local().length() < 2.5 => stopped.push(scene.memory.rolls()),
                    _ => {}
                }
            }
        }
        let rates = [
            share(&resting, |rolls| rolls <= 0.5),
            share(&rolling, |rolls| rolls > 0.5),
            share(&stopped, |rolls| rolls <= 0.5),
        ];
        let counts = [resting.len(), rolling.len(), stopped.len()];
        println!("robot at {speed} m/s: right when resting, rolling, stopped: {rates:.3?} of {counts:?}");
        assert!(rates.into_iter().all(|rate| rate > 0.95), "{rates:?}");
    }
}

#[test]
fn prediction_of_a_rolling_ball_matches_its_motion() {
    let (mut predicted, mut stayed, mut inside, mut speeds) = (vec![], vec![], vec![], vec![]);
    for seed in 2000..2200 {
        let mut scene = Scene::new(seed);
        (0..30).for_each(|_| scene.step(0.0, 0.3));
        scene.kick(0.6);
        (0..15).for_each(|_| scene.step(0.0, 0.3));
        speeds.push(scene.memory.velocity().distance(scene.velocity));
        let prediction = scene.memory.predict(1.0).expect("seen");
        let last = scene.memory.position().expect("seen");
        (0..30).for_each(|_| scene.roll());
        let off = scene.local() - prediction.position;
        inside.push(off.dot(prediction.covariance.try_inverse().expect("a covariance") * off));
        predicted.push(off.length());
        stayed.push(scene.local().distance(last));
    }
    let inside = share(&inside, |value| value < 5.99);
    let (predicted, stayed, speed) = (median(predicted), median(stayed), median(speeds));
    println!("1 s ahead: {predicted:.3} m off, {stayed:.3} m without rolling; within 95 %: {inside:.3}");
    println!("velocity {speed:.3} m/s off");
    assert!(predicted < 0.18 && predicted < 0.25 * stayed);
    assert!(inside > 0.9);
    assert!(speed < 0.15);
}

#[test]
fn unseen_rolling_ball_decelerates_and_stops() {
    let mut scene = Scene::new(7);
    scene.ball = Vec2::new(0.3, 0.0);
    (0..10).for_each(|_| scene.step(0.0, 0.0));
    scene.kick(1.0);
    (0..15).for_each(|_| scene.step(0.0, 0.0));
    let seen = scene.memory.estimate().expect("seen");
    for _ in 0..30 {
        scene.roll();
        scene.memory.advance(Pose2::ORIGIN, STEP);
    }
    let place = scene.memory.estimate().expect("remembered");
    assert!(place.position.distance(seen.position) > 0.4, "{place:?}");
    assert!(place.position.distance(scene.local()) < 0.2, "{place:?} is not {}", scene.local());
    assert!(largest(&place.covariance) > 2.0 * largest(&seen.covariance));
    let ends = [5.0, 8.0].map(|seconds| scene.memory.predict(seconds).expect("remembered").position);
    assert!(ends[0].distance(ends[1]) < 0.01, "{ends:?}");
}

/// The robot looks away immediately after an outlier.
#[test]
fn single_outlier_does_not_make_the_ball_roll() {
    for (seed, way) in [(11, Vec2::X), (12, Vec2::Y), (13, Vec2::NEG_X), (14, Vec2::ONE)] {
        let mut scene = Scene::new(seed);
        scene.ball = Vec2::new(0.33, 0.02);
        (0..30).for_each(|_| scene.step(0.0, 0.0));
        let spread = spread(scene.local());
        scene.memory.advance(Pose2::ORIGIN, STEP);
        scene.memory.see(scene.local() + 5.0 * largest(&spread) * way, &spread, 0.8);
        (0..120).for_each(|_| scene.memory.advance(Pose2::ORIGIN, STEP));
        let place = scene.memory.likeliest().expect("remembered").position;
        assert!(place.distance(scene.local()) < 0.15, "{way}: {place} is not {}", scene.local());
    }
}

#[test]
fn moved_ball_is_remembered_at_its_new_position() {
    let mut scene = Scene::new(3);
    (0..30).for_each(|_| scene.step(0.0, 0.0));
    scene.ball = Vec2::new(1.0, -1.5);
    (0..4).for_each(|_| scene.step(0.0, 0.0));
    let place = scene.memory.position().expect("seen");
    assert!(place.distance(scene.local()) < 0.2, "{place} is not {}", scene.local());
}

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        Just(f32::NAN),
        Just(f32::INFINITY),
        Just(f32::MAX),
        Just(f32::MIN_POSITIVE),
        Just(1e-20_f32),
        Just(1e18_f32),
        Just(0.0_f32),
        -3.0_f32..3.0,
        0.0_f32..0.1,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn memory_is_finite_for_any_input(
        half_life in number(),
        steps in prop::collection::vec((prop::array::uniform4(number()), prop::array::uniform3(number()), any::<bool>()), 0..40),
    ) {
        let mut memory = BallMemory::new(half_life);
        for ([a, b, c, d], [xx, xy, yy], see) in steps {
            let covariance = Covariance::from_cols_array(&[xx, xy, xy, yy]);
            if see { memory.see(Vec2::new(a, b), &covariance, c) } else { memory.advance(Pose2::new(a, b, c), d) }
            for place in [memory.estimate(), memory.predict(c)].into_iter().flatten() {
                prop_assert!(place.position.is_finite() && place.covariance.is_finite());
            }
            prop_assert!((0.0..=1.0).contains(&memory.rolls()) && memory.velocity().is_finite());
            prop_assert!((0.0..=1.0).contains(&memory.confidence()) && memory.age().is_none_or(f32::is_finite));
        }
    }

    #[test]
    fn robot_motion_transforms_position_and_velocity(
        motions in prop::collection::vec((-0.05_f32..0.05, -0.05_f32..0.05, -0.2_f32..0.2), 1..20), seed in 0_u64..50,
    ) {
        let mut scene = Scene::new(seed);
        (0..5).for_each(|_| scene.step(0.0, 0.0));
        scene.kick(0.8);
        (0..10).for_each(|_| scene.step(0.0, 0.0));
        let (mut still, mut robot) = (scene.memory, Pose2::ORIGIN);
        let mut moving = still;
        for (x, y, heading) in motions {
            robot = robot * Pose2::new(x, y, heading);
            moving.advance(Pose2::new(x, y, heading), 0.01);
            still.advance(Pose2::ORIGIN, 0.01);
        }
        let place = robot.place(moving.position().expect("remembered"));
        prop_assert!(place.distance(still.position().expect("remembered")) < 2e-3, "{place}");
        let velocity = rotate(moving.velocity(), robot.heading);
        prop_assert!(velocity.distance(still.velocity()) < 2e-2, "{velocity}");
    }
}
