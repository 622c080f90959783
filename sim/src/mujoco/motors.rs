//! Motors: commands act after their dead time, and pull the joints to their targets with limited torque.

use std::collections::VecDeque;

use bica_motion::head::HeadAngles;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::Command;

use super::model::STEP;
use super::physics::Physics;

/// What a joint is to be at, and how hard.
type Aim = (Joints, Joints);

/// All motors of a robot.
pub(crate) struct Motors {
    /// Commands on their way and the steps that are left until they act, the oldest first.
    waiting: VecDeque<(u32, Aim)>,
    acting: Aim,
    delay: u32,
    gains: Joints,
    limits: Joints,
}

impl Motors {
    /// Motors that hold these angles.
    pub(crate) fn holding(angles: Joints, physics: &Physics) -> Self {
        let (mut gains, mut limits) = (Joints::all(0.0), Joints::all(0.0));
        for joint in Joint::ALL {
            (gains[joint], limits[joint]) = strength(joint, physics);
        }
        let delay = libm::roundf(physics.dead_time / STEP) as u32;
        Self { waiting: VecDeque::new(), acting: (angles, Joints::all(1.0)), delay, gains, limits }
    }

    /// Takes a command. Targets beyond the limits stop there; what is no number holds nothing.
    pub(crate) fn command(&mut self, command: &Command) {
        let (mut targets, mut stiffness) = (command.targets, command.stiffness);
        for joint in 0..JOINTS {
            let usable = targets.0[joint].is_finite() && stiffness.0[joint].is_finite();
            stiffness.0[joint] = if usable { stiffness.0[joint].clamp(0.0, 1.0) } else { 0.0 };
        }
        targets = targets.clamp_to_limits::<Nao>();
        HeadAngles::read(&targets).clamped::<Nao>().write(&mut targets);
        self.waiting.push_back((self.delay, (targets, stiffness)));
    }

    /// Lets a motor pull no more.
    pub(crate) fn break_down(&mut self, joint: Joint) {
        self.gains[joint] = 0.0;
    }

    /// The torques of all joints in the next step, Nm, where the joints are at these angles.
    pub(crate) fn step(&mut self, angles: &Joints) -> Joints {
        while let Some((0, aim)) = self.waiting.front() {
            self.acting = *aim;
            self.waiting.pop_front();
        }
        for (left, _) in &mut self.waiting {
            *left -= 1;
        }
        let (targets, stiffness) = &self.acting;
        Joints(core::array::from_fn(|i| {
            let torque = self.gains.0[i] * stiffness.0[i] * (targets.0[i] - angles.0[i]);
            torque.clamp(-self.limits.0[i], self.limits.0[i])
        }))
    }
}

/// The currents for these torques behind the gears, A.
pub(crate) fn currents(torques: &Joints) -> Joints {
    Joints(core::array::from_fn(|i| Nao::ACTUATORS[Joint::ALL[i]].current(torques.0[i])))
}

/// A motor's gain at full stiffness, Nm/rad, and its greatest torque, Nm: between values published for other simulators. With
/// the joints' damping a joint without load turns at 0.7 to 1.3 times the published speed: legs at 5 rad/s, where the robot's
/// roll at 4.5 and pitch at 7.0.
const fn strength(joint: Joint, physics: &Physics) -> (f32, f32) {
    use Joint::{
        HeadPitch, HeadYaw, LElbowRoll, LElbowYaw, LHand, LShoulderPitch, LShoulderRoll, LWristYaw, RElbowRoll,
        RElbowYaw, RHand, RShoulderPitch, RShoulderRoll, RWristYaw,
    };
    match joint {
        HeadYaw | HeadPitch => (15.0, 2.0),
        LShoulderPitch | LShoulderRoll | LElbowYaw | LElbowRoll | RShoulderPitch | RShoulderRoll | RElbowYaw
        | RElbowRoll => (15.0, 2.5),
        LWristYaw | RWristYaw => (2.0, 0.6),
        LHand | RHand => (0.5, 0.3),
        _ => (40.0 * physics.leg_gain, physics.torque_limit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bica_motion::robot::{CameraId, Lights};

    fn command(target: f32, stiffness: f32) -> Command {
        let (targets, stiffness) = (Joints::all(target), Joints::all(stiffness));
        Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Top }
    }

    fn torque(motors: &mut Motors) -> f32 {
        motors.step(&Joints::all(0.0))[Joint::LKneePitch]
    }

    #[test]
    fn a_command_acts_after_its_dead_time() {
        for (dead_time, steps) in [(0.0, 0), (0.03, 15), (0.04, 20)] {
            let mut motors = Motors::holding(Joints::all(0.0), &Physics { dead_time, ..Physics::default() });
            motors.command(&command(0.05, 1.0));
            for _ in 0..steps {
                assert_eq!(torque(&mut motors), 0.0);
            }
            assert!((torque(&mut motors) - 2.0).abs() < 1e-6);
        }
    }

    #[test]
    fn torque_has_its_limit_and_stiffness_its_share() {
        let physics = Physics { dead_time: 0.0, torque_limit: 3.0, ..Physics::default() };
        for (target, stiffness, expected) in [(1.0, 1.0, 3.0), (0.05, 0.5, 1.0), (0.05, 0.0, 0.0), (0.05, 7.0, 2.0)] {
            let mut motors = Motors::holding(Joints::all(0.0), &physics);
            motors.command(&command(target, stiffness));
            assert!((torque(&mut motors) - expected).abs() < 1e-6, "{target} {stiffness}");
        }
    }

    #[test]
    fn what_is_no_number_holds_nothing() {
        for wrong in [command(f32::NAN, 1.0), command(0.1, f32::NAN), command(f32::INFINITY, 1.0)] {
            let mut motors = Motors::holding(Joints::all(0.0), &Physics { dead_time: 0.0, ..Physics::default() });
            motors.command(&wrong);
            assert_eq!(torque(&mut motors), 0.0);
        }
    }
}
