//! What a state of the robot says, checked.

use std::fmt;

use bica_motion::robot::{Inertial, Sensors, is_plausible_angle, plausible_temperature};
use glam::Vec3;

use crate::body::Body;
use crate::message::{LowState, MotorState};

/// Tilt of a torso that lies, or falls beyond what a motion can stop, rad.
const LYING: f32 = 0.7;

/// Range of the specific force along each axis, m/s²: that of the accelerometer with which the detection of falls was tuned. Its filter
/// would take the peak of an impact for the weight of a robot that lies.
const FORCE_RANGE: f32 = 2.0 * 9.81;

/// Why a state is not used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// The lists have other numbers of motors than the robot: those of the serial and of the parallel one.
    Motors(usize, usize),
    /// A value is not finite, or no sensor measures it.
    Value,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Motors(serial, parallel) => {
                write!(f, "it has {serial} joints and {parallel} motors, which is another robot's number")
            }
            Self::Value => f.write_str("a value is not finite, or out of range"),
        }
    }
}

/// Returns the sensor values of a state: angles from the serial list, temperatures from the parallel one if there is one, and the robot's
/// own estimate of the tilt. The forces on the soles are not measured. The specific force is limited to 2 g along each axis.
///
/// # Errors
/// If a list has another number of motors than the robot, or a value is not finite or out of range.
pub fn sensors(body: &Body, state: &LowState) -> Result<Sensors<'static>, Mistake> {
    let (serial, parallel) = (&state.motor_state_serial, &state.motor_state_parallel);
    let count = body.motors.len();
    if serial.len() != count || !(parallel.is_empty() || parallel.len() == count) {
        return Err(Mistake::Motors(serial.len(), parallel.len()));
    }
    let is_finite = |motor: &MotorState| [motor.q, motor.dq, motor.ddq, motor.tau_est].iter().all(|it| it.is_finite());
    let is_in_order = serial.iter().chain(parallel).all(is_finite)
        && serial.iter().all(|motor| is_plausible_angle(motor.q))
        && is_plausible_angle(state.imu_state.rpy[2]);
    let [roll, pitch, _] = state.imu_state.rpy;
    let (gyro, acceleration) = (Vec3::from(state.imu_state.gyro), Vec3::from(state.imu_state.acc));
    let inertial = Inertial { gyro, acceleration, roll, pitch };
    if !is_in_order || !inertial.is_plausible() {
        return Err(Mistake::Value);
    }
    let acceleration = acceleration.clamp(Vec3::splat(-FORCE_RANGE), Vec3::splat(FORCE_RANGE));
    let mut sensors = Sensors { inertial: Inertial { acceleration, ..inertial }, ..Sensors::UNMEASURED };
    let temperatures = if parallel.is_empty() { serial } else { parallel };
    for ((joint, motor), hot) in body.motors.iter().zip(serial).zip(temperatures) {
        sensors.angles[*joint] = motor.q;
        sensors.temperatures[*joint] = plausible_temperature(f32::from(hot.temperature));
    }
    Ok(sensors)
}

/// Whether the torso lies, or falls.
#[must_use]
pub fn is_lying(inertial: &Inertial) -> bool {
    inertial.roll.abs().max(inertial.pitch.abs()) > LYING
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joint;

    use super::*;
    use crate::body::{K1, T1};

    fn state(body: &Body) -> LowState {
        let motors: Vec<_> = (0..body.motors.len())
            .map(|index| MotorState { q: 0.01 * index as f32, temperature: 30 + index as u8, ..MotorState::default() })
            .collect();
        LowState { motor_state_parallel: motors.clone(), motor_state_serial: motors, ..LowState::default() }
    }

    #[test]
    fn angles_belong_to_their_joints() {
        let measured = sensors(T1, &state(T1)).expect("it is right");
        assert!((measured.angles[Joint::WAIST_YAW] - 0.10).abs() < 1e-6);
        assert!((measured.angles[Joint::RAnkleRoll] - 0.22).abs() < 1e-6);
        assert!((measured.temperatures[Joint::LHipPitch] - 41.0).abs() < 1e-6);
        let measured = sensors(K1, &state(K1)).expect("it is right");
        assert!((measured.angles[Joint::LHipPitch] - 0.10).abs() < 1e-6);
    }

    #[test]
    fn specific_force_of_an_impact_is_limited() {
        let mut state = state(T1);
        state.imu_state.acc = [-3.0, -150.0, 30.0];
        let force = sensors(T1, &state).expect("it is right").inertial.acceleration;
        assert!((force - Vec3::new(-3.0, -19.62, 19.62)).length() < 1e-4, "{force}");
    }

    #[test]
    fn other_numbers_of_motors_are_refused() {
        let of = |serial, parallel| {
            let mut state = state(T1);
            state.motor_state_serial.resize_with(serial, MotorState::default);
            state.motor_state_parallel.resize_with(parallel, MotorState::default);
            sensors(T1, &state).err()
        };
        assert_eq!((of(23, 23), of(23, 0)), (None, None));
        assert_eq!((of(22, 22), of(23, 22)), (Some(Mistake::Motors(22, 22)), Some(Mistake::Motors(23, 22))));
        assert_eq!((of(0, 0), of(24, 23)), (Some(Mistake::Motors(0, 0)), Some(Mistake::Motors(24, 23))));
    }

    #[test]
    fn each_value_that_is_not_finite_is_refused() {
        let spoilt: [fn(&mut LowState, f32); 8] = [
            |state, value| state.imu_state.rpy[2] = value,
            |state, value| state.imu_state.gyro[1] = value,
            |state, value| state.imu_state.acc[0] = value,
            |state, value| state.motor_state_serial[22].q = value,
            |state, value| state.motor_state_serial[3].dq = value,
            |state, value| state.motor_state_serial[4].ddq = value,
            |state, value| state.motor_state_serial[5].tau_est = value,
            |state, value| state.motor_state_parallel[0].q = value,
        ];
        for spoil in spoilt {
            for value in [f32::NAN, f32::INFINITY] {
                let mut state = state(T1);
                spoil(&mut state, value);
                assert_eq!(sensors(T1, &state).err(), Some(Mistake::Value));
            }
        }
    }
}
