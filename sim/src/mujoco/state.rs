//! Where everything is, read from MuJoCo's arrays and written to them.

use bica_field::FIELD;
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::Pose2;
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3};
use mujoco_rs::prelude::{MjData, MjModel};

use super::model::Place;
use super::sensor_model::Truth;

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// Lets the robot stand over a place.
pub(crate) fn stand(data: &mut MjData<Box<MjModel>>, torso: Place, joints: &[usize], at: Pose2) {
    let sole = Skeleton::<Nao>::of(&Nao::STAND).sole(Side::Left);
    let turn = Quat::from_rotation_z(at.heading);
    let numbers = [at.position.x, at.position.y, -sole.translation.z, turn.w, turn.x, turn.y, turn.z];
    write(&mut data.qpos_mut()[torso.position..], &numbers);
    for (&place, angle) in joints.iter().zip(Nao::STAND.0) {
        data.qpos_mut()[place] = angle.into();
    }
}

/// Puts the ball somewhere, at rest.
pub(crate) fn place(data: &mut MjData<Box<MjModel>>, ball: Place, at: Vec2) {
    write(&mut data.qpos_mut()[ball.position..], &[at.x, at.y, BALL_RADIUS, 1.0, 0.0, 0.0, 0.0]);
    data.qvel_mut()[ball.velocity..][..6].fill(0.0);
}

/// Writes numbers to the first places.
pub(crate) fn write(to: &mut [f64], numbers: &[f32]) {
    for (to, number) in to.iter_mut().zip(numbers) {
        *to = f64::from(*number);
    }
}

/// The joints' angles.
pub(crate) fn angles(data: &MjData<Box<MjModel>>, joints: &[usize; JOINTS]) -> Joints {
    Joints(joints.map(|place| data.qpos()[place] as f32))
}

/// The pose of a body that moves freely, field frame.
pub(crate) fn pose(data: &MjData<Box<MjModel>>, body: Place) -> Affine3A {
    let at = |i: usize| data.qpos()[body.position + i] as f32;
    let turn = Quat::from_xyzw(at(4), at(5), at(6), at(3)).normalize();
    Affine3A::from_rotation_translation(turn, Vec3::new(at(0), at(1), at(2)))
}

/// What the sensors would say if they were perfect.
pub(crate) fn truth(data: &MjData<Box<MjModel>>, torso: Place, joints: &[usize; JOINTS]) -> Truth {
    let sensed = |i: usize| data.sensordata()[i] as f32;
    let three = |i: usize| Vec3::new(sensed(i), sensed(i + 1), sensed(i + 2));
    let foot = |i: usize| FootPressure {
        front_left: sensed(i),
        front_right: sensed(i + 1),
        rear_left: sensed(i + 2),
        rear_right: sensed(i + 3),
    };
    let turn = pose(data, torso).matrix3;
    Truth {
        angles: angles(data, joints),
        gyro: three(0),
        acceleration: three(3),
        rise: Vec3::new(turn.x_axis.z, turn.y_axis.z, turn.z_axis.z),
        feet: [foot(6), foot(10)],
    }
}
