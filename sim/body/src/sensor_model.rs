//! Resolution, range and noise of the body's sensors, common to both simulators.

use core::f32::consts::TAU;

use bica_motion::joints::Joints;
use bica_motion::robot::{FootPressure, Inertial};
use glam::Vec3;
use libm::{asinf, atan2f, roundf};

/// Gravity, m/s².
pub const GRAVITY: f32 = 9.81;
/// Standard deviation of the gyroscope, rad/s. Source: variance in B-Human 2023 `NaoProvider.h`.
const GYRO_NOISE: f32 = 0.001_97;
/// Standard deviation of the accelerometer, m/s². Source: as for the gyroscope.
const ACCELERATION_NOISE: f32 = 0.0193;
/// Standard deviation of the estimated torso angles, rad (our estimate).
const ANGLE_NOISE: f32 = 0.002;
/// Standard deviation of a pressure sensor under load, N (our estimate).
pub const PRESSURE_NOISE: f32 = 0.2;
/// Range of the accelerometer, m/s² (±2 g).
pub const ACCELEROMETER_RANGE: f32 = 2.0 * GRAVITY;
/// Resolution of a joint's encoder, rad: 12 bits per turn.
const ENCODER_RESOLUTION: f32 = TAU / 4096.0;

/// Measures an angular velocity, rad/s, a specific force, m/s², and the z components `up` of the torso's axes.
///
/// `noise` draws a number with the standard deviation that it receives.
#[must_use]
pub fn measure_inertia(gyro: Vec3, force: Vec3, up: Vec3, mut noise: impl FnMut(f32) -> f32) -> Inertial {
    let mut vector = |deviation: f32| Vec3::new(noise(deviation), noise(deviation), noise(deviation));
    Inertial {
        gyro: gyro + vector(GYRO_NOISE),
        acceleration: force + vector(ACCELERATION_NOISE),
        roll: atan2f(up.y, up.z) + noise(ANGLE_NOISE),
        pitch: asinf((-up.x).clamp(-1.0, 1.0)) + noise(ANGLE_NOISE),
    }
}

/// Rounds joint angles to the resolution of the encoders.
#[must_use]
pub fn encode(angles: &Joints) -> Joints {
    Joints(angles.0.map(|angle| ENCODER_RESOLUTION * roundf(angle / ENCODER_RESOLUTION)))
}

/// Adds noise, N, to the forces on a sole; a sole without load reads exactly 0.
#[must_use]
pub fn measure_pressure(force: &FootPressure, mut noise: impl FnMut() -> f32) -> FootPressure {
    let mut measure = |force: f32| (force + noise()).max(0.0);
    let measured = FootPressure {
        front_left: measure(force.front_left),
        front_right: measure(force.front_right),
        rear_left: measure(force.rear_left),
        rear_right: measure(force.rear_right),
    };
    if force.total() > 0.0 { measured } else { FootPressure::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foot_in_air_measures_nothing() {
        assert_eq!(measure_pressure(&FootPressure::default(), || 0.5), FootPressure::default());
    }

    #[test]
    fn noise_never_makes_a_pressure_negative() {
        let force = FootPressure { front_left: 1.0, ..FootPressure::default() };
        let measured = measure_pressure(&force, || -0.5);
        assert_eq!(measured, FootPressure { front_left: 0.5, ..FootPressure::default() });
    }

    #[test]
    fn encoder_rounds_to_the_nearest_step() {
        let step = TAU / 4096.0;
        let read = encode(&Joints::all(10.4 * step)).0[0];
        assert!((read - 10.0 * step).abs() < 1e-7, "{read}");
        let read = encode(&Joints::all(-10.6 * step)).0[0];
        assert!((read + 11.0 * step).abs() < 1e-7, "{read}");
    }
}
