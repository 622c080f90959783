//! Motors: proportional position control with dead time and torque limits.

use std::collections::VecDeque;

use bica_motion::head::HeadAngles;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::robot::Command;
use bica_motion::side::Side;

use super::model::STEP;
use super::physics::Physics;

/// Target angles, rad, and stiffness, 0 to 1.
type Setpoint = (Joints, Joints);

/// All motors of a robot.
pub(crate) struct Motors {
    /// Setpoints within the dead time, each with the number of steps until it acts, the oldest first.
    pending: VecDeque<(u32, Setpoint)>,
    acting: Setpoint,
    /// Dead time, steps of the physics.
    delay: u32,
    /// Position gain at full stiffness, Nm/rad.
    gains: Joints,
    /// Torque limits, Nm.
    limits: Joints,
}

impl Motors {
    /// Returns motors that hold these angles at full stiffness.
    pub(crate) fn holding(model: &'static SimulatedModel, angles: Joints, physics: &Physics) -> Self {
        let (mut gains, mut limits) = (*model.mujoco.gains, *model.mujoco.torque_limits);
        let knee = model.mujoco.torque_limits[Joint::LKneePitch];
        let [left, right] = Side::BOTH.map(|side| model.leg_joints(side));
        // Both legs may share the hip yaw-pitch.
        for joint in left.into_iter().chain(right.into_iter().filter(|joint| !left.contains(joint))) {
            gains[joint] *= physics.leg_gain;
            limits[joint] *= physics.torque_limit / knee;
        }
        let delay = libm::roundf(physics.dead_time / STEP) as u32;
        Self { pending: VecDeque::new(), acting: (angles, Joints::all(1.0)), delay, gains, limits }
    }

    /// Holds these angles at full stiffness until the next command acts.
    pub(crate) fn hold(&mut self, angles: Joints) {
        self.pending.clear();
        self.acting = (angles, Joints::all(1.0));
    }

    /// Accepts a command. Targets are clamped to the joint limits; a joint with a target or stiffness that is not finite gets no
    /// stiffness.
    pub(crate) fn command(&mut self, model: &'static RobotModel, command: &Command) {
        let (mut targets, mut stiffness) = (command.targets, command.stiffness);
        for joint in 0..JOINTS {
            let usable = targets.0[joint].is_finite() && stiffness.0[joint].is_finite();
            stiffness.0[joint] = if usable { stiffness.0[joint].clamp(0.0, 1.0) } else { 0.0 };
        }
        targets = targets.clamp_to_limits(model);
        HeadAngles::read(&targets).clamped(model).write(&mut targets);
        self.pending.push_back((self.delay, (targets, stiffness)));
    }

    /// Removes the torque of a motor permanently.
    pub(crate) fn fail(&mut self, joint: Joint) {
        self.gains[joint] = 0.0;
    }

    /// Advances by one step of the physics. Returns the torques of all joints at these angles, Nm, without the
    /// `damping` torques of the velocity gains. The sum of both stays within the limits.
    pub(crate) fn step(&mut self, angles: &Joints, damping: &Joints) -> Joints {
        while let Some((0, setpoint)) = self.pending.front() {
            self.acting = *setpoint;
            self.pending.pop_front();
        }
        for (left, _) in &mut self.pending {
            *left -= 1;
        }
        let (targets, stiffness) = &self.acting;
        Joints(core::array::from_fn(|i| {
            let torque = self.gains.0[i] * stiffness.0[i] * (targets.0[i] - angles.0[i]);
            torque.clamp(damping.0[i] - self.limits.0[i], damping.0[i] + self.limits.0[i])
        }))
    }
}

/// Returns the currents for these joint torques, A.
pub(crate) fn currents(model: &'static RobotModel, torques: &Joints) -> Joints {
    Joints(core::array::from_fn(|i| model.actuators[Joint::ALL[i]].current(torques.0[i])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    fn command(target: f32, stiffness: f32) -> Command {
        Command::new(Joints::all(target), stiffness)
    }

    fn torque(motors: &mut Motors) -> f32 {
        motors.step(&Joints::all(0.0), &Joints::all(0.0))[Joint::LKneePitch]
    }

    #[test]
    fn command_acts_after_dead_time() {
        for (dead_time, steps) in [(0.0, 0), (0.03, 15), (0.04, 20)] {
            let mut motors =
                Motors::holding(TEST_MODEL, Joints::all(0.0), &Physics { dead_time, ..Physics::of(TEST_MODEL) });
            motors.command(TEST_MODEL, &command(0.05, 1.0));
            for _ in 0..steps {
                assert_eq!(torque(&mut motors), 0.0);
            }
            assert!((torque(&mut motors) - 2.0).abs() < 1e-6);
        }
    }

    #[test]
    fn torque_is_proportional_to_stiffness_up_to_limit() {
        let physics = Physics { dead_time: 0.0, torque_limit: 3.0, ..Physics::of(TEST_MODEL) };
        for (target, stiffness, expected) in [(1.0, 1.0, 3.0), (0.05, 0.5, 1.0), (0.05, 0.0, 0.0), (0.05, 7.0, 2.0)] {
            let mut motors = Motors::holding(TEST_MODEL, Joints::all(0.0), &physics);
            motors.command(TEST_MODEL, &command(target, stiffness));
            assert!((torque(&mut motors) - expected).abs() < 1e-6, "{target} {stiffness}");
        }
    }

    #[test]
    fn joint_with_invalid_command_has_no_torque() {
        for wrong in [command(f32::NAN, 1.0), command(0.1, f32::NAN), command(f32::INFINITY, 1.0)] {
            let mut motors =
                Motors::holding(TEST_MODEL, Joints::all(0.0), &Physics { dead_time: 0.0, ..Physics::of(TEST_MODEL) });
            motors.command(TEST_MODEL, &wrong);
            assert_eq!(torque(&mut motors), 0.0);
        }
    }
}
