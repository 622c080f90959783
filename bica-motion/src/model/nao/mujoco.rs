//! The body in `MuJoCo`: the files of `models/nao`, and the strength of the motors.

use glam::Vec2;

use crate::joints::{JOINTS, Joint, Joints};
use crate::model::simulation::MujocoModel;

pub(super) const MUJOCO: MujocoModel = MujocoModel {
    robot: include_str!("../../../models/nao/robot.xml"),
    bystander: include_str!("../../../models/nao/bystander.xml"),
    shells: include_str!("../../../models/nao/shells.xml"),
    gains: &STRENGTHS.0,
    torque_limits: &STRENGTHS.1,
    motors_damp: false,
    shadows: [Vec2::new(0.1, 0.062), Vec2::new(0.15, 0.15)],
};

const STRENGTHS: (Joints, Joints) = {
    let (mut gains, mut limits) = ([0.0; JOINTS], [0.0; JOINTS]);
    let mut i = 0;
    while i < JOINTS {
        (gains[i], limits[i]) = strength(Joint::ALL[i]);
        i += 1;
    }
    (Joints(gains), Joints(limits))
};

/// Position gain at full stiffness, Nm/rad, and torque limit, Nm.
///
/// The values lie between those published for other simulators. With the damping of the joints the no-load speed is 0.65 to 1.3
/// times the published one: 5 rad/s in the legs, where the robot's roll joints have 4.5 and its pitch joints 7.0.
const fn strength(joint: Joint) -> (f32, f32) {
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
        _ => (40.0, 5.0),
    }
}
