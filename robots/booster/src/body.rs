//! The robots: order, ranges and gains of their motors.

use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::simulation::{self, SimulatedModel};
use bica_motion::model::{HeadPitchLimit, Range, RobotModel};

/// A robot of Booster, as its motors are addressed.
#[derive(Debug)]
pub struct Body {
    /// Its model: name, stand, and ranges, which are narrower than the simulated ones where the robot's stops are nearer.
    pub model: &'static RobotModel,
    /// Joint of each motor, in the robot's order.
    pub motors: &'static [Joint],
    /// Position gain of each joint at full stiffness, Nm/rad: those with which the gait was tuned.
    pub kp: &'static Joints,
    /// Largest torque of each joint, Nm.
    pub torque: &'static Joints,
}

/// Order of the T1's motors: the waist is between arms and legs.
const T1_MOTORS: [Joint; 23] = {
    let joints = simulation::T1.robot.joints;
    let mut motors = [Joint::WAIST_YAW; 23];
    let mut i = 0;
    while i < K1_MOTORS.len() {
        motors[if i < FIRST_LEG { i } else { i + 1 }] = joints[i];
        i += 1;
    }
    motors
};
/// Order of the K1's motors: head, arms, legs.
const K1_MOTORS: &[Joint] = simulation::K1.robot.joints;
/// Number of motors before the legs.
const FIRST_LEG: usize = 10;

pub(crate) const fn range(min: f32, max: f32) -> Range {
    Range { min, max }
}

/// The ranges of a model, of which some are narrower. Source: B-Human's release of 2025.
const fn narrowed<const N: usize>(model: &RobotModel, narrower: [(Joint, Range); N]) -> Joints<Range> {
    let (mut limits, mut i) = (*model.limits, 0);
    while i < N {
        limits.0[narrower[i].0.index()] = narrower[i].1;
        i += 1;
    }
    limits
}

const T1_LIMITS: Joints<Range> = narrowed(
    simulation::T1.robot,
    [
        (Joint::HeadYaw, range(-1.01, 1.01)),
        (Joint::HeadPitch, range(-0.31, 0.95)),
        (Joint::WAIST_YAW, range(-1.01, 1.01)),
    ],
);
const K1_LIMITS: Joints<Range> = narrowed(simulation::K1.robot, [(Joint::HeadPitch, range(-0.30, 0.75))]);

const T1_MODEL: &RobotModel = &RobotModel {
    limits: &T1_LIMITS,
    head_pitch_limits: &[HeadPitchLimit::degrees(0.0, -17.7, 54.4)],
    ..*simulation::T1.robot
};
const K1_MODEL: &RobotModel = &RobotModel {
    limits: &K1_LIMITS,
    head_pitch_limits: &[HeadPitchLimit::degrees(0.0, -17.1, 42.9)],
    ..*simulation::K1.robot
};

/// Booster T1.
pub const T1: &Body = &body(T1_MODEL, simulation::T1, &T1_MOTORS);

/// Booster K1.
pub const K1: &Body = &body(K1_MODEL, simulation::K1, K1_MOTORS);

const fn body(model: &'static RobotModel, simulated: &'static SimulatedModel, motors: &'static [Joint]) -> Body {
    Body { model, motors, kp: simulated.mujoco.gains, torque: simulated.mujoco.torque_limits }
}

/// Velocity gain of each joint, Nm·s/rad: the damping of the motor controllers in the models with which the gait was tuned.
const KD: Joints = {
    let mut gains = Joints([1.0; JOINTS]);
    let mut i = 0;
    while i < JOINTS {
        gains.0[i] = match Joint::ALL[i] {
            Joint::LHipPitch | Joint::RHipPitch | Joint::LHipRoll | Joint::RHipRoll => 20.0,
            Joint::LEFT_HIP_YAW | Joint::RIGHT_HIP_YAW => 12.0,
            Joint::LKneePitch | Joint::RKneePitch => 15.0,
            Joint::LAnklePitch | Joint::RAnklePitch | Joint::LAnkleRoll | Joint::RAnkleRoll => 6.0,
            Joint::WAIST_YAW => 5.0,
            _ => 1.0,
        };
        i += 1;
    }
    gains
};

impl Body {
    /// The robot with a name, `t1` or `k1`.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        [T1, K1].into_iter().find(|body| body.model.id == name)
    }

    /// Range of the targets of a joint, rad.
    #[must_use]
    pub fn range(&self, joint: Joint) -> Range {
        self.model.limits[joint]
    }

    /// Velocity gain of a joint, Nm·s/rad.
    #[must_use]
    pub const fn kd(&self, joint: Joint) -> f32 {
        KD.0[joint.index()]
    }

    /// Whether a joint belongs to a leg.
    #[must_use]
    pub fn is_in_leg(&self, joint: Joint) -> bool {
        let first_leg = self.motors.iter().position(|motor| *motor == Joint::LHipPitch);
        self.motors.iter().position(|motor| *motor == joint) >= first_leg
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motors_have_the_makers_order() {
        assert_eq!((T1.motors.len(), K1.motors.len()), (23, 22));
        let named = |body: &Body, index: usize| format!("{:?}", body.motors[index]);
        let of_t1 = [0, 1, 2, 6, 11, 13, 14, 16, 17, 22].map(|index| named(T1, index));
        let expected = [
            "HeadYaw",
            "HeadPitch",
            "LShoulderPitch",
            "RShoulderPitch",
            "LHipPitch",
            "LHipYawPitch",
            "LKneePitch",
            "LAnkleRoll",
            "RHipPitch",
            "RAnkleRoll",
        ];
        assert_eq!(of_t1, expected);
        assert_eq!(T1.motors[10], Joint::WAIST_YAW);
        assert_eq!((T1.motors[19], K1.motors[18]), (Joint::RIGHT_HIP_YAW, Joint::RIGHT_HIP_YAW));
    }

    #[test]
    fn each_joint_has_one_motor_and_gains() {
        for (body, simulated) in [(T1, simulation::T1), (K1, simulation::K1)] {
            let mut motors: Vec<_> = body.motors.to_vec();
            motors.sort();
            let mut joints = body.model.joints.to_vec();
            joints.sort();
            assert_eq!(motors, joints);
            for joint in joints {
                let (kp, kd, Range { min, max }) = (body.kp[joint], body.kd(joint), body.range(joint));
                assert!((1.0..=1000.0).contains(&kp) && (0.1..=50.0).contains(&kd) && min < max, "{joint:?}");
                let widest = simulated.robot.limits[joint];
                assert!(widest.min <= min && max <= widest.max, "{joint:?}");
            }
        }
    }

    #[test]
    fn legs_are_twelve_joints() {
        for body in [T1, K1] {
            assert_eq!(body.motors.iter().filter(|joint| body.is_in_leg(**joint)).count(), 12);
        }
    }
}
