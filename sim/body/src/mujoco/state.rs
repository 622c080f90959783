//! Access to the state in MuJoCo's arrays.

use bica_motion::joints::Joints;
use bica_motion::kinematics::Skeleton;
use bica_motion::model::RobotModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec3};
use mujoco_rs::prelude::{MjData, MjModel};

use super::model::{Drive, FreeJoint};
use super::sensor_model::IdealMeasurement;

/// State of all simulated objects.
pub type Data = MjData<Box<MjModel>>;

/// Sets the robot to its standing posture above a pose on the ground.
pub(crate) fn stand(model: &'static RobotModel, data: &mut Data, torso: FreeJoint, drives: &[Drive], at: Pose2) {
    let sole = Skeleton::of(model, &model.stand).sole(Side::Left);
    let (turn, at) = (Quat::from_rotation_z(at.heading), at.position.extend(-sole.translation.z));
    place(data, torso, drives, (turn, at), &model.stand);
}

/// Sets the rotation and the position of the robot frame, and the joint angles.
pub(crate) fn place(data: &mut Data, torso: FreeJoint, drives: &[Drive], (turn, at): (Quat, Vec3), angles: &Joints) {
    write(&mut data.qpos_mut()[torso.position..], &[at.x, at.y, at.z, turn.w, turn.x, turn.y, turn.z]);
    for drive in drives {
        data.qpos_mut()[drive.position] = angles[drive.joint].into();
    }
}

/// Writes numbers to the first elements.
pub fn write(to: &mut [f64], numbers: &[f32]) {
    for (to, number) in to.iter_mut().zip(numbers) {
        *to = f64::from(*number);
    }
}

/// Returns the joint angles; 0 for joints that the robot does not have.
pub(crate) fn angles(data: &Data, drives: &[Drive]) -> Joints {
    let mut angles = Joints::all(0.0);
    for drive in drives {
        angles[drive.joint] = data.qpos()[drive.position] as f32;
    }
    angles
}

/// Returns the pose of a body with a free joint, world frame.
#[must_use]
pub fn pose(data: &Data, body: FreeJoint) -> Affine3A {
    let at = |i: usize| data.qpos()[body.position + i] as f32;
    let turn = Quat::from_xyzw(at(4), at(5), at(6), at(3)).normalize();
    Affine3A::from_rotation_translation(turn, Vec3::new(at(0), at(1), at(2)))
}

/// Returns the measurements of ideal sensors.
pub(crate) fn ideal_measurement(data: &Data, torso: FreeJoint, drives: &[Drive]) -> IdealMeasurement {
    // A robot without pressure sensors measures no force.
    let sensed = |i: usize| data.sensordata().get(i).map_or(0.0, |&value| value as f32);
    let three = |i: usize| Vec3::new(sensed(i), sensed(i + 1), sensed(i + 2));
    let foot = |i: usize| FootPressure {
        front_left: sensed(i),
        front_right: sensed(i + 1),
        rear_left: sensed(i + 2),
        rear_right: sensed(i + 3),
    };
    IdealMeasurement {
        angles: angles(data, drives),
        gyro: three(0),
        acceleration: three(3),
        up: pose(data, torso).matrix3.row(2).into(),
        feet: [foot(6), foot(10)],
    }
}
