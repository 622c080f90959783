//! Limits of what the robot is sent.

use bica_motion::joints::Joints;

use crate::body::Body;
use crate::message::{LowCmd, MotorCmd, SERIAL};

/// Largest speed of a target, rad/s: half of what the robot may be sent, so that commands which arrive closer to each other than they were
/// sent are in order, too.
const MAX_SPEED: f32 = 10.0;
/// Longest time for which a target may have moved from one command to the next, s.
const MAX_STEP_SECONDS: f32 = 0.012;

/// Largest distance of the target of a joint that gets stiffness from its measured angle, rad.
const MAX_START: f32 = 0.15;

/// Makes commands: targets within the joints' ranges, which move at a limited speed, and start at the measured angles where a joint gets
/// stiffness.
#[derive(Clone, Debug)]
pub struct Limiter {
    body: &'static Body,
    /// Targets of the last command with gains, rad, and its stiffness.
    last: Option<(Joints, Joints)>,
}

impl Limiter {
    /// Limits of a robot whose motors have no gains yet.
    #[must_use]
    pub const fn new(body: &'static Body) -> Self {
        Self { body, last: None }
    }

    /// Targets of the last command, rad; the measured angles within the ranges if the motors have no gains.
    #[must_use]
    pub fn targets(&self, measured: &Joints) -> Joints {
        self.last.map_or_else(|| self.within(measured), |(targets, _)| targets)
    }

    fn within(&self, angles: &Joints) -> Joints {
        let mut targets = *angles;
        for &joint in self.body.motors {
            targets[joint] = self.body.range(joint).clamp(angles[joint]);
        }
        targets
    }

    /// Command with gains, `seconds` after the last one: targets in rad and stiffness from 0 to 1 for all joints, and measured angles in
    /// rad. A target that is not finite is not used.
    pub fn command(&mut self, targets: &Joints, stiffness: &Joints, measured: &Joints, seconds: f32) -> LowCmd {
        let (before, stiff) = self.last.unwrap_or_else(|| (self.within(measured), Joints::all(0.0)));
        let step = MAX_SPEED * seconds.clamp(0.0, MAX_STEP_SECONDS);
        let (mut limited, mut shares) = (before, Joints::all(0.0));
        for &joint in self.body.motors {
            let last = before[joint];
            let share = if stiffness[joint].is_finite() { stiffness[joint].clamp(0.0, 1.0) } else { 0.0 };
            let is_near = (last - measured[joint]).abs() <= MAX_START;
            shares[joint] = if stiff[joint] > 0.0 || is_near { share } else { 0.0 };
            // The target of a limp joint is where the joint is.
            let wanted = if shares[joint] > 0.0 { targets[joint] } else { measured[joint] };
            let wanted = if wanted.is_finite() { self.body.range(joint).clamp(wanted) } else { last };
            limited[joint] = wanted.clamp(last - step, last + step);
        }
        self.last = Some((limited, shares));
        let motor = |joint| {
            let (kp, kd) = (self.body.kp[joint] * shares[joint], self.body.kd(joint));
            MotorCmd { q: limited[joint], kp, kd, weight: 1.0, ..MotorCmd::default() }
        };
        self.message(motor)
    }

    /// Command without gains and weight: it changes nothing in another mode. The next one with gains starts at the measured angles again.
    pub fn limp(&mut self, measured: &Joints) -> LowCmd {
        self.last = None;
        let targets = self.within(measured);
        self.message(|joint| MotorCmd { q: targets[joint], ..MotorCmd::default() })
    }

    fn message(&self, motor: impl Fn(bica_motion::joints::Joint) -> MotorCmd) -> LowCmd {
        LowCmd { cmd_type: SERIAL, motor_cmd: self.body.motors.iter().map(|joint| motor(*joint)).collect() }
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::JOINTS;
    use bica_motion::model::Range;
    use proptest::prelude::*;

    use super::*;
    use crate::body::{K1, T1};

    fn values() -> impl Strategy<Value = Joints> {
        let value = prop_oneof![8 => -10.0_f32..10.0, 1 => Just(f32::NAN), 1 => Just(f32::INFINITY)];
        prop::collection::vec(value, JOINTS).prop_map(|values| Joints(values.try_into().expect("their number")))
    }

    fn angles() -> impl Strategy<Value = Joints> {
        prop::collection::vec(-0.3_f32..0.3, JOINTS).prop_map(|values| Joints(values.try_into().expect("their number")))
    }

    /// Checks what the interface asks of each command.
    fn check(body: &Body, command: &LowCmd) {
        assert_eq!((command.cmd_type, command.motor_cmd.len()), (SERIAL, body.motors.len()));
        for (joint, motor) in body.motors.iter().zip(&command.motor_cmd) {
            let Range { min, max } = body.range(*joint);
            assert!((min..=max).contains(&motor.q), "{joint:?}: {motor:?}");
            assert!((0.0..=1000.0).contains(&motor.kp) && (0.0..=50.0).contains(&motor.kd), "{joint:?}: {motor:?}");
            assert!(motor.kp <= 0.0 || motor.kd > 0.0, "{joint:?}: {motor:?}");
            assert!((0.0..=1.0).contains(&motor.weight) && motor.tau == 0.0 && motor.dq == 0.0 && motor.mode == 0);
        }
    }

    proptest! {
        #[test]
        fn no_targets_leave_the_limits(
            measured in angles(),
            commands in prop::collection::vec((values(), values(), 0.0_f32..0.1), 1..20),
            is_t1 in any::<bool>(),
        ) {
            let body = if is_t1 { T1 } else { K1 };
            let mut limiter = Limiter::new(body);
            let mut last = limiter.limp(&measured);
            check(body, &last);
            for (joint, motor) in body.motors.iter().zip(&last.motor_cmd) {
                prop_assert!(motor.kp == 0.0 && motor.kd == 0.0 && (motor.q - measured[*joint]).abs() < 0.3);
            }
            for (targets, stiffness, seconds) in commands {
                let command = limiter.command(&targets, &stiffness, &measured, seconds);
                check(body, &command);
                for (index, (before, after)) in last.motor_cmd.iter().zip(&command.motor_cmd).enumerate() {
                    prop_assert!((after.q - before.q).abs() <= 10.0 * seconds.min(0.012) + 1e-5);
                    let starts = before.kp <= 0.0 && after.kp > 0.0;
                    prop_assert!(!starts || (after.q - measured[body.motors[index]]).abs() <= 0.3);
                }
                last = command;
            }
        }
    }

    #[test]
    fn targets_are_reached_and_start_anew_when_limp() {
        let mut limiter = Limiter::new(T1);
        let (zero, stand) = (Joints::all(0.0), T1.model.stand);
        for _ in 0..100 {
            limiter.command(&stand, &Joints::all(1.0), &zero, 0.01);
        }
        for &joint in T1.motors {
            assert!((limiter.targets(&zero)[joint] - stand[joint]).abs() < 1e-4, "{joint:?}");
        }
        limiter.limp(&zero);
        assert!(limiter.targets(&zero)[T1.motors[14]].abs() < 1e-6);
    }
}
