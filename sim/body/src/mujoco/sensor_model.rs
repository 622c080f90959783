//! Body sensors with delay and noise.

use std::collections::VecDeque;

use bica_motion::joints::Joints;
use bica_motion::robot::{FootPressure, Inertial};
use bica_motion::side::Side;
use glam::Vec3;

use super::model::STEP;
use super::physics::Physics;
use crate::random::Random;
use crate::sensor_model::{ACCELEROMETER_RANGE, PRESSURE_NOISE, encode, measure_inertia, measure_pressure};

/// Averaging window of the inertial unit, steps of the physics: one control cycle.
const WINDOW: usize = 5;
/// Ideal measurements in one step of the physics.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IdealMeasurement {
    /// Joint angles, rad.
    pub(crate) angles: Joints,
    /// Angular velocity, torso frame, rad/s.
    pub(crate) gyro: Vec3,
    /// Specific force, torso frame, m/s².
    pub(crate) acceleration: Vec3,
    /// Vertical direction in the torso frame: the z components of the torso's axes.
    pub(crate) up: Vec3,
    /// Forces on the soles, left first.
    pub(crate) feet: [FootPressure; 2],
}

/// Measurements of the body's sensors in one cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measurement {
    pub(crate) angles: Joints,
    pub(crate) inertial: Inertial,
    pub(crate) feet: [FootPressure; 2],
}

/// State of the body's sensors.
pub(crate) struct SensorModel {
    /// Ideal measurements within delay and window, the newest last.
    history: VecDeque<IdealMeasurement>,
    /// Steps of the physics.
    delay: usize,
    /// Factor on all noise.
    noise: f32,
    random: Random,
    gyroscope_failed: bool,
    /// Left first.
    failed_soles: [bool; 2],
}

impl SensorModel {
    /// Returns the sensors of a body at rest.
    pub(crate) fn new(now: IdealMeasurement, random: Random, physics: &Physics) -> Self {
        let delay = libm::roundf(physics.sensor_delay / STEP) as usize;
        let history = core::iter::repeat_n(now, delay + WINDOW).collect();
        Self { history, delay, noise: physics.noise, random, gyroscope_failed: false, failed_soles: [false; 2] }
    }

    /// Advances by one step of the physics.
    pub(crate) fn step(&mut self, now: IdealMeasurement) {
        self.history.pop_front();
        self.history.push_back(now);
    }

    /// Makes the gyroscope measure zero from now on.
    pub(crate) const fn fail_gyroscope(&mut self) {
        self.gyroscope_failed = true;
    }

    /// Makes a sole measure zero from now on.
    pub(crate) const fn fail_sole(&mut self, side: Side) {
        self.failed_soles[side.index()] = true;
    }

    /// Reads all sensors; to be called once per cycle.
    pub(crate) fn measure(&mut self) -> Measurement {
        let delayed = self.history[self.history.len() - 1 - self.delay];
        let [gyro, acceleration] = self.means();
        let mut noise = |deviation: f32| self.noise * deviation * self.random.normal();
        let mut inertial = measure_inertia(gyro, acceleration, delayed.up, &mut noise);
        if self.gyroscope_failed {
            inertial.gyro = Vec3::ZERO;
        }
        let mut feet = delayed.feet.map(|foot| measure_pressure(&foot, || noise(PRESSURE_NOISE)));
        for (foot, failed) in feet.iter_mut().zip(self.failed_soles) {
            if failed {
                *foot = FootPressure::default();
            }
        }
        Measurement { angles: encode(&delayed.angles), inertial, feet }
    }

    /// Returns the means of angular velocity and specific force over a window whose centre has the age of the delay, or the
    /// newest window if the delay is shorter than half of it.
    fn means(&self) -> [Vec3; 2] {
        let newest = self.history.len() - self.delay.saturating_sub(WINDOW / 2);
        let window = self.history.range(newest - WINDOW..newest);
        let limit = |force: Vec3| force.clamp(Vec3::splat(-ACCELEROMETER_RANGE), Vec3::splat(ACCELEROMETER_RANGE));
        let sums =
            window.fold([Vec3::ZERO; 2], |[gyro, force], ideal| [gyro + ideal.gyro, force + limit(ideal.acceleration)]);
        sums.map(|sum| sum / WINDOW as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::sensor_model::GRAVITY;
    use bica_motion::joints::Joint;

    /// Returns measurements that are proportional to the step.
    fn ideal(step: usize) -> IdealMeasurement {
        let now = step as f32;
        let foot = FootPressure { front_left: now, front_right: now, rear_left: now, rear_right: now };
        IdealMeasurement {
            angles: Joints::all(0.1 * now),
            gyro: Vec3::splat(now),
            acceleration: Vec3::splat(0.1 * now),
            up: Vec3::new(-libm::sinf(0.01 * now), 0.0, libm::cosf(0.01 * now)),
            feet: [foot; 2],
        }
    }

    #[test]
    fn each_measurement_has_age_of_delay() {
        for (sensor_delay, steps) in [(0.0, 0), (0.006, 3), (0.04, 20)] {
            let physics = Physics { sensor_delay, noise: 0.0, ..Physics::of(TEST_MODEL) };
            let mut sensors = SensorModel::new(ideal(0), Random::new(1, 2_u64), &physics);
            for step in 1..=100 {
                sensors.step(ideal(step));
            }
            let measured = sensors.measure();
            let mean = steps.max(WINDOW / 2);
            for (what, value, steps) in [
                ("angles", measured.angles[Joint::HeadYaw] / 0.1, steps),
                ("pitch", measured.inertial.pitch / 0.01, steps),
                ("left sole", measured.feet[0].total() / 4.0, steps),
                ("right sole", measured.feet[1].rear_right, steps),
                ("gyroscope", measured.inertial.gyro.x, mean),
                ("accelerometer", measured.inertial.acceleration.z / 0.1, mean),
            ] {
                let age = 100.0 - value;
                assert!((age - steps as f32).abs() < 0.02, "{what}: {age} {steps}");
            }
        }
    }

    #[test]
    fn noise_has_published_deviation_times_factor() {
        // Variances in B-Human 2023 `NaoProvider.h`; the other two are our estimates.
        let (gyro, acceleration) = (libm::sqrtf(3.87e-6), libm::sqrtf(3.74e-4));
        for noise in [0.0, 1.0, 5.0] {
            let still = IdealMeasurement { up: Vec3::Z, ..ideal(0) };
            let still = IdealMeasurement { feet: ideal(10).feet, ..still };
            let mut sensors =
                SensorModel::new(still, Random::new(1, 2_u64), &Physics { noise, ..Physics::of(TEST_MODEL) });
            let mut squares = [0.0_f32; 10];
            for _ in 0..3_000 {
                let Measurement { inertial, feet, .. } = sensors.measure();
                let (turn, force) = (inertial.gyro, inertial.acceleration);
                let pressures = [feet[0].front_left - 10.0, feet[1].rear_right - 10.0];
                let value = [turn.x, turn.y, turn.z, force.x, force.y, force.z, inertial.roll, inertial.pitch];
                for (square, off) in squares.iter_mut().zip(value.into_iter().chain(pressures)) {
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
    fn accelerometer_saturates_at_two_g() {
        let hit =
            IdealMeasurement { acceleration: Vec3::new(100.0, -100.0, GRAVITY), feet: Default::default(), ..ideal(0) };
        let measured =
            SensorModel::new(hit, Random::new(1, 2_u64), &Physics { noise: 0.0, ..Physics::of(TEST_MODEL) }).measure();
        assert!((measured.inertial.acceleration - Vec3::new(19.62, -19.62, GRAVITY)).length() < 1e-3);
        let noisy =
            SensorModel::new(hit, Random::new(1, 2_u64), &Physics { noise: 10.0, ..Physics::of(TEST_MODEL) }).measure();
        assert_eq!(noisy.feet, <[FootPressure; 2]>::default());
    }
}
