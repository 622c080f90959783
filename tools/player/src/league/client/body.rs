//! Robots of the league: names and gains of their motors.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::simulation::{self, SimulatedModel};
use bica_motion::model::{Parameters, Profile};
use bica_motion::walk::Velocity;
use glam::Vec2;

/// A robot of the league.
#[derive(Debug)]
pub(crate) struct Body {
    /// Its model.
    pub(crate) model: &'static SimulatedModel,
    /// Name of the robot's model in the server.
    pub(crate) server_name: &'static str,
    /// Height of the torso over the ground with all joints at zero, m.
    pub(crate) standing_height: f32,
    /// Gait and kicks in the server, whose ground is soft: a foot sinks into it by some millimetres.
    pub(crate) profile: &'static Profile,
}

/// Booster T1.
pub(crate) const T1: &Body = &Body {
    model: simulation::T1,
    server_name: "T1",
    standing_height: 0.675,
    profile: &Profile { gait: T1_GAIT, ..*simulation::T1.robot.dynamic_profile },
};

/// Booster K1.
pub(crate) const K1: &Body = &Body {
    model: simulation::K1,
    server_name: "K1",
    standing_height: 0.555,
    profile: &Profile { gait: K1_GAIT, ..*simulation::K1.robot.dynamic_profile },
};

/// Gait found by a random search that counted falls in the server, whose motors lag less than those of our `MuJoCo`.
const T1_GAIT: Parameters = Parameters {
    half_spacing: 0.106,
    torso_offset: -0.005,
    step_duration: 0.3,
    step_height: 0.069,
    pendulum_height: 0.6,
    max_speed_up: Velocity::new(0.08, 0.08, 0.4),
    velocity_drift: Velocity::new(0.08, 0.0, 0.0),
    velocity_scale: Velocity::new(1.03, 1.0, 1.15),
    earliest_support_switch: 0.75,
    gyro_smoothing: 0.1,
    ankle_pitch_gain: 0.08,
    ankle_roll_gain: 0.028,
    hip_roll_offset: 0.03,
    lag_compensation: 0.0,
    ankle_pitch_offset: 0.0,
    torso_pitch: -0.04,
    capture_sway: 0.02,
    recovery_weights: [1.0, 0.03, 1.0],
    capture_deadband: Vec2::new(0.04, 0.03),
    max_inward_step: 0.025,
    start_shift: 0.0,
    velocity_smoothing: None,
    capture_offset: Vec2::ZERO,
    kick_max_distance: 0.0,
    ..simulation::T1.robot.dynamic_profile.gait
};

/// Gait of the K1 in `MuJoCo`, with the step height and the smoothing of the T1, and with motors that lag less.
const K1_GAIT: Parameters = Parameters {
    step_duration: 0.3,
    step_height: 0.069,
    torso_pitch: -0.04,
    ankle_roll_gain: 0.028,
    gyro_smoothing: 0.1,
    lag_compensation: 0.0,
    ankle_pitch_offset: 0.0,
    max_speed_up: Velocity::new(0.08, 0.08, 0.4),
    velocity_drift: Velocity::new(0.12, 0.0, 0.0),
    kick_max_distance: 0.0,
    ..simulation::K1.robot.dynamic_profile.gait
};

/// Velocity gains of the motors, Nm·s/rad. The server computes the velocity term explicitly in steps of 5 ms: higher gains make
/// light joints oscillate.
pub(crate) const VELOCITY_GAINS: Joints = {
    let mut gains = Joints::all(1.0);
    let mut i = 0;
    while i < Joint::ALL.len() {
        gains.0[i] = match Joint::ALL[i] {
            Joint::LHipPitch | Joint::RHipPitch | Joint::LHipRoll | Joint::RHipRoll => 15.0,
            Joint::LKneePitch | Joint::RKneePitch => 12.0,
            Joint::LEFT_HIP_YAW | Joint::RIGHT_HIP_YAW | Joint::WAIST_YAW => 4.0,
            Joint::LAnklePitch | Joint::RAnklePitch | Joint::LAnkleRoll | Joint::RAnkleRoll => 2.0,
            _ => 1.0,
        };
        i += 1;
    }
    gains
};

/// Name of the motor of a joint; empty if the robots of the league lack the joint.
pub(crate) const fn effector(joint: Joint) -> &'static str {
    match joint {
        Joint::HeadYaw => "he1",
        Joint::HeadPitch => "he2",
        Joint::LShoulderPitch => "lae1",
        Joint::LShoulderRoll => "lae2",
        Joint::LElbowYaw => "lae3",
        Joint::LElbowRoll => "lae4",
        Joint::RShoulderPitch => "rae1",
        Joint::RShoulderRoll => "rae2",
        Joint::RElbowYaw => "rae3",
        Joint::RElbowRoll => "rae4",
        Joint::WAIST_YAW => "te1",
        Joint::LHipPitch => "lle1",
        Joint::LHipRoll => "lle2",
        Joint::LEFT_HIP_YAW => "lle3",
        Joint::LKneePitch => "lle4",
        Joint::LAnklePitch => "lle5",
        Joint::LAnkleRoll => "lle6",
        Joint::RHipPitch => "rle1",
        Joint::RHipRoll => "rle2",
        Joint::RIGHT_HIP_YAW => "rle3",
        Joint::RKneePitch => "rle4",
        Joint::RAnklePitch => "rle5",
        Joint::RAnkleRoll => "rle6",
        _ => "",
    }
}

/// Returns the joint of a sensor: the sensor `q_llj4` belongs to the motor `lle4`.
pub(crate) fn joint_of(sensor: &str) -> Option<Joint> {
    let (limb, number) = sensor.strip_prefix("q_")?.rsplit_once('j')?;
    Joint::ALL.into_iter().find(|&joint| effector(joint).rsplit_once('e') == Some((limb, number)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_joint_has_its_motor_and_its_sensor() {
        fn check(body: &Body, count: usize) {
            let motors = body.model.joints.iter().map(|&joint| (joint, effector(joint)));
            assert_eq!(motors.clone().filter(|(_, motor)| !motor.is_empty()).count(), count, "{}", body.model.name);
            for (joint, motor) in motors {
                let (limb, number) = motor.rsplit_once('e').expect("an effector");
                assert_eq!(joint_of(&format!("q_{limb}j{number}")), Some(joint));
            }
        }
        check(T1, 23);
        check(K1, 22);
        assert_eq!((joint_of("q_"), joint_of("lle4"), joint_of("q_llj9")), (None, None, None));
    }
}
