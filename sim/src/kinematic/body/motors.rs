//! Motors: joints follow their targets after a dead time, at limited speed.

use core::iter::repeat_n;
use std::collections::VecDeque;

use bica_motion::head::HeadAngles;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::robot::Command;
use bica_motion::side::Side;

use crate::world::CYCLE_SECONDS;
use bica_body::motor_heat::MotorHeat;

/// Minimum stiffness for full speed; below it the speed is proportional to the stiffness (our estimate).
const FULL_SPEED_STIFFNESS: f32 = 0.2;

/// Current to hold a leg joint, as a fraction of the continuous current. Our estimate; this simulator has no forces.
const LEG_HOLDING: f32 = 0.4;
/// Current to hold any other joint, as a fraction of the continuous current (our estimate).
const OTHER_HOLDING: f32 = 0.1;
/// Additional current at full speed, as a fraction of the continuous current (our estimate).
const MOVING: f32 = 0.6;

/// All motors of a robot.
#[derive(Clone, Debug)]
pub(crate) struct Motors {
    angles: Joints,
    /// Targets and stiffness of the dead time and one more cycle, the oldest first; the oldest ones act.
    waiting: VecDeque<(Joints, Joints)>,
    heat: MotorHeat,
}

impl Motors {
    /// Returns motors at rest at these angles.
    pub(crate) fn holding(model: &'static SimulatedModel, angles: Joints) -> Self {
        let delay = (model.dead_time / CYCLE_SECONDS + 0.5) as usize;
        let waiting = repeat_n((angles, Joints::all(1.0)), delay + 1).collect();
        Self { angles, waiting, heat: MotorHeat::new(model) }
    }

    /// Brings all motors to rest at these angles; they stay as warm as they are.
    pub(crate) fn hold(&mut self, angles: Joints) {
        self.angles = angles;
        self.waiting.iter_mut().for_each(|waiting| *waiting = (angles, Joints::all(1.0)));
    }

    /// True angles, rad.
    pub(crate) const fn angles(&self) -> &Joints {
        &self.angles
    }

    /// Temperatures and currents.
    pub(crate) const fn heat(&self) -> &MotorHeat {
        &self.heat
    }

    /// Sets the temperature of a motor, °C.
    pub(crate) fn set_temperature(&mut self, joint: Joint, temperature: f32) {
        self.heat.set(joint, temperature);
    }

    /// Stiffness that acts after the dead time, 0 to 1.
    pub(crate) fn stiffness(&self, joint: Joint) -> f32 {
        self.waiting.back().map_or(0.0, |(_, stiffness)| stiffness[joint])
    }

    /// Moves the joints for one cycle. Targets are clamped to the joint limits; a joint with a target or stiffness that is not
    /// finite does not move.
    pub(crate) fn step(&mut self, model: &'static RobotModel, command: &Command) {
        self.waiting.pop_front();
        self.waiting.push_back((command.targets, command.stiffness));
        let due = self.waiting[0];
        let before = self.angles;
        let moved = self.angles.moved_toward(model, &due.0, CYCLE_SECONDS).clamp_to_limits(model);
        for i in 0..JOINTS {
            let strength = (due.1.0[i] / FULL_SPEED_STIFFNESS).clamp(0.0, 1.0);
            if strength > 0.0 {
                self.angles.0[i] += strength * (moved.0[i] - self.angles.0[i]);
            }
        }
        HeadAngles::read(&self.angles).clamped(model).write(&mut self.angles);
        self.heat.step(currents(model, &before, &self.angles, &due.1));
    }
}

/// Returns the currents of a cycle between these angles at this stiffness, A.
fn currents(model: &'static RobotModel, before: &Joints, after: &Joints, stiffness: &Joints) -> Joints {
    Joints(Joint::ALL.map(|joint| {
        let is_leg = Side::BOTH.iter().any(|side| model.leg_joints(*side).contains(&joint));
        let holding = if is_leg { LEG_HOLDING } else { OTHER_HOLDING };
        let speed = (after[joint] - before[joint]).abs() / CYCLE_SECONDS / model.max_speeds[joint];
        let stiffness = if stiffness[joint] > 0.0 { stiffness[joint].min(1.0) } else { 0.0 };
        model.continuous_current(joint) * (holding * stiffness + MOVING * speed)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    fn command(target: f32, stiffness: f32) -> Command {
        Command::new(Joints::all(target), stiffness)
    }

    #[test]
    fn limp_joint_or_invalid_target_does_not_move() {
        for wrong in [command(0.5, 0.0), command(f32::NAN, 1.0), command(0.5, f32::NAN), command(0.5, -1.0)] {
            let held = Joints::all(0.0).clamp_to_limits(TEST_MODEL);
            let mut motors = Motors::holding(TEST_MODEL, held);
            for _ in 0..10 {
                motors.step(TEST_MODEL, &wrong);
            }
            assert_eq!(*motors.angles(), held);
        }
    }

    #[test]
    fn speed_is_proportional_to_stiffness_below_a_fifth() {
        for (stiffness, share) in [(0.1, 0.5), (0.2, 1.0), (1.0, 1.0)] {
            let mut motors = Motors::holding(TEST_MODEL, Joints::all(0.3));
            for _ in 0..4 {
                motors.step(TEST_MODEL, &command(0.9, stiffness));
            }
            let moved = motors.angles()[Joint::LKneePitch] - 0.3;
            let expected = share * TEST_MODEL.max_speeds[Joint::LKneePitch] * 0.01;
            assert!((moved - expected).abs() < 1e-6, "stiffness {stiffness}: {moved}");
        }
    }

    #[test]
    fn moving_needs_more_current_than_holding() {
        let mut motors = Motors::holding(TEST_MODEL, Joints::all(0.3).clamp_to_limits(TEST_MODEL));
        motors.step(TEST_MODEL, &command(0.3, 1.0));
        for (joint, share) in [(Joint::LKneePitch, 0.4), (Joint::RAnkleRoll, 0.4), (Joint::HeadYaw, 0.1)] {
            let current = motors.heat().currents()[joint];
            assert!((current - share * TEST_MODEL.continuous_current(joint)).abs() < 1e-4, "{joint:?}: {current}");
        }
        for _ in 0..4 {
            motors.step(TEST_MODEL, &command(0.9, 1.0));
        }
        let current = motors.heat().currents()[Joint::LKneePitch];
        assert!((current - TEST_MODEL.continuous_current(Joint::LKneePitch)).abs() < 1e-3, "{current}");
    }

    #[test]
    fn joints_stop_at_their_limits() {
        let mut motors = Motors::holding(TEST_MODEL, Joints::all(0.3));
        for _ in 0..300 {
            motors.step(TEST_MODEL, &command(9.0, 1.0));
        }
        assert!(motors.angles().within_limits(TEST_MODEL));
        let head = HeadAngles::read(motors.angles());
        assert_eq!(head, head.clamped(TEST_MODEL));
    }
}
