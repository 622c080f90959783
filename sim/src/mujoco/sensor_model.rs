//! What the body's sensors say: late and with noise.

use std::collections::VecDeque;

use bica_motion::joints::Joints;
use bica_motion::robot::{FootPressure, Inertial};
use bica_motion::side::Side;
use glam::Vec3;
use libm::{asinf, atan2f};

use super::model::STEP;
use super::physics::Physics;
use crate::random::{Random, Stream};
use crate::sensor_model::{
    ACCELERATION_NOISE, ACCELEROMETER_RANGE, ANGLE_NOISE, GYRO_NOISE, PRESSURE_NOISE, encode, measure_pressure,
};

/// The inertial unit gives means over this many steps: a control cycle.
const MEAN: usize = 5;
/// What is true in one step of the physics.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Truth {
    /// Joint angles.
    pub(crate) angles: Joints,
    /// Angular velocity, torso frame, rad/s.
    pub(crate) gyro: Vec3,
    /// Specific force, torso frame, m/s².
    pub(crate) acceleration: Vec3,
    /// The torso's axes: the height of each one's tip.
    pub(crate) rise: Vec3,
    /// Left first.
    pub(crate) feet: [FootPressure; 2],
}

/// What the sensors say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measurement {
    pub(crate) angles: Joints,
    pub(crate) inertial: Inertial,
    pub(crate) feet: [FootPressure; 2],
}

/// The sensors of a body.
pub(crate) struct SensorModel {
    /// The newest last.
    truths: VecDeque<Truth>,
    delay: usize,
    noise: f32,
    random: Random,
    gyroscope_is_dead: bool,
    /// Left first.
    dead_soles: [bool; 2],
}

impl SensorModel {
    /// Sensors of a body that has been as it is now for long.
    pub(crate) fn new(now: Truth, seed: u64, physics: &Physics) -> Self {
        let delay = libm::roundf(physics.sensor_delay / STEP) as usize;
        let truths = core::iter::repeat_n(now, delay + MEAN).collect();
        let random = Random::new(seed, Stream::Sensors);
        Self { truths, delay, noise: physics.noise, random, gyroscope_is_dead: false, dead_soles: [false; 2] }
    }

    /// Lets one step of the physics pass.
    pub(crate) fn step(&mut self, now: Truth) {
        self.truths.pop_front();
        self.truths.push_back(now);
    }

    /// Lets the gyroscope say from now on that nothing turns.
    pub(crate) const fn break_gyroscope(&mut self) {
        self.gyroscope_is_dead = true;
    }

    /// Lets a sole say from now on that nothing presses.
    pub(crate) const fn break_sole(&mut self, side: Side) {
        self.dead_soles[side.index()] = true;
    }

    /// Reads all sensors; once per cycle.
    pub(crate) fn feel(&mut self) -> Measurement {
        let late = self.truths[self.truths.len() - 1 - self.delay];
        let [gyro, acceleration] = self.means();
        let mut deviate = |deviation: f32| self.noise * deviation * self.random.normal();
        let mut around = |deviation: f32| Vec3::new(deviate(deviation), deviate(deviation), deviate(deviation));
        let gyro = gyro + around(GYRO_NOISE);
        let inertial = Inertial {
            gyro: if self.gyroscope_is_dead { Vec3::ZERO } else { gyro },
            acceleration: acceleration + around(ACCELERATION_NOISE),
            roll: atan2f(late.rise.y, late.rise.z) + deviate(ANGLE_NOISE),
            pitch: asinf((-late.rise.x).clamp(-1.0, 1.0)) + deviate(ANGLE_NOISE),
        };
        let mut feet = late.feet.map(|foot| measure_pressure(&foot, || deviate(PRESSURE_NOISE)));
        for (foot, dead) in feet.iter_mut().zip(self.dead_soles) {
            if dead {
                *foot = FootPressure::default();
            }
        }
        Measurement { angles: encode(&late.angles), inertial, feet }
    }

    /// What the inertial unit measures: means over a cycle whose middle is as old as the delay says, if it can be.
    fn means(&self) -> [Vec3; 2] {
        let newest = self.truths.len() - self.delay.saturating_sub(MEAN / 2);
        let window = self.truths.range(newest - MEAN..newest);
        let limit = |force: Vec3| force.clamp(Vec3::splat(-ACCELEROMETER_RANGE), Vec3::splat(ACCELEROMETER_RANGE));
        let sums =
            window.fold([Vec3::ZERO; 2], |[gyro, force], truth| [gyro + truth.gyro, force + limit(truth.acceleration)]);
        sums.map(|sum| sum / MEAN as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensor_model::GRAVITY;
    use bica_motion::joints::Joint;

    /// Everything grows with the steps.
    fn truth(step: usize) -> Truth {
        let now = step as f32;
        let foot = FootPressure { front_left: now, front_right: now, rear_left: now, rear_right: now };
        Truth {
            angles: Joints::all(0.1 * now),
            gyro: Vec3::splat(now),
            acceleration: Vec3::splat(0.1 * now),
            rise: Vec3::new(-libm::sinf(0.01 * now), 0.0, libm::cosf(0.01 * now)),
            feet: [foot; 2],
        }
    }

    #[test]
    fn everything_is_as_old_as_the_delay_says() {
        for (sensor_delay, steps) in [(0.0, 0), (0.006, 3), (0.04, 20)] {
            let physics = Physics { sensor_delay, noise: 0.0, ..Physics::default() };
            let mut senses = SensorModel::new(truth(0), 1, &physics);
            for step in 1..=100 {
                senses.step(truth(step));
            }
            let felt = senses.feel();
            let mean = steps.max(MEAN / 2);
            for (what, told, steps) in [
                ("angles", felt.angles[Joint::HeadYaw] / 0.1, steps),
                ("pitch", felt.inertial.pitch / 0.01, steps),
                ("left sole", felt.feet[0].total() / 4.0, steps),
                ("right sole", felt.feet[1].rear_right, steps),
                ("gyroscope", felt.inertial.gyro.x, mean),
                ("accelerometer", felt.inertial.acceleration.z / 0.1, mean),
            ] {
                let age = 100.0 - told;
                assert!((age - steps as f32).abs() < 0.02, "{what}: {age} {steps}");
            }
        }
    }

    #[test]
    fn noise_is_that_of_a_nao_times_the_factor_asked_for() {
        // Variances in B-Human 2023 `NaoProvider.h`; the other two are our estimates.
        let (gyro, acceleration) = (libm::sqrtf(3.87e-6), libm::sqrtf(3.74e-4));
        for noise in [0.0, 1.0, 5.0] {
            let still = Truth { rise: Vec3::Z, ..truth(0) };
            let still = Truth { feet: truth(10).feet, ..still };
            let mut senses = SensorModel::new(still, 1, &Physics { noise, ..Physics::default() });
            let mut squares = [0.0_f32; 10];
            for _ in 0..3_000 {
                let Measurement { inertial, feet, .. } = senses.feel();
                let (turn, force) = (inertial.gyro, inertial.acceleration);
                let pressures = [feet[0].front_left - 10.0, feet[1].rear_right - 10.0];
                let told = [turn.x, turn.y, turn.z, force.x, force.y, force.z, inertial.roll, inertial.pitch];
                for (square, off) in squares.iter_mut().zip(told.into_iter().chain(pressures)) {
                    *square += off * off / 3_000.0;
                }
            }
            let published = [gyro, gyro, gyro, acceleration, acceleration, acceleration, 0.002, 0.002, 0.2, 0.2];
            for (i, (square, one)) in squares.iter().zip(published).enumerate() {
                let (deviation, expected) = (libm::sqrtf(*square), noise * one);
                assert!((deviation - expected).abs() <= 0.05 * expected, "{i}: {deviation} {expected}");
            }
        }
    }

    #[test]
    fn the_accelerometer_ends_at_two_g_and_a_foot_in_the_air_feels_nothing() {
        let hit = Truth { acceleration: Vec3::new(100.0, -100.0, GRAVITY), feet: Default::default(), ..truth(0) };
        let felt = SensorModel::new(hit, 1, &Physics { noise: 0.0, ..Physics::default() }).feel();
        assert!((felt.inertial.acceleration - Vec3::new(19.62, -19.62, GRAVITY)).length() < 1e-3);
        let noisy = SensorModel::new(hit, 1, &Physics { noise: 10.0, ..Physics::default() }).feel();
        assert_eq!(noisy.feet, <[FootPressure; 2]>::default());
    }
}
