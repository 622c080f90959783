//! The MJCF file must agree with the robot model.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{Segment, Skeleton, YawFrom, ankle, legs_angles};
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::{HUMANOIDS, NAO, SimulatedModel};
use bica_motion::robot::{CameraId, Command};
use bica_motion::side::Side;
use glam::{Vec3, Vec3A};
use mujoco_rs::prelude::{MjData, MjtObjBase};

use super::model::joint_name;
use super::motors::Motors;
use super::{Data, Model, Physics, body_name, find};
use crate::random::Random;

fn built(model: &'static SimulatedModel) -> Model {
    Model::on_floor(model, &Physics::of(model)).unwrap()
}

/// Returns the state of the model with the robot frame at the origin of the field and these angles.
fn posed(model: Model, angles: &Joints) -> Data {
    let right = find(&model.physics, MjtObjBase::mjOBJ_JOINT, "RHipYawPitch").ok();
    let right = right.map(|joint| model.physics.jnt_qposadr()[joint] as usize);
    let mut data = MjData::new(model.physics);
    data.qpos_mut()[model.torso.position..][..7].copy_from_slice(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    for drive in &model.drives {
        data.qpos_mut()[drive.position] = angles[drive.joint].into();
    }
    if let Some(right) = right {
        data.qpos_mut()[right] = angles[Joint::LHipYawPitch].into();
    }
    data.forward_kinematics();
    data
}

fn any_angles(model: &'static RobotModel, random: &mut Random) -> Joints {
    let mut angles = Joints::all(0.0);
    // Fingers have mass but are not part of the kinematics; neither is the waist, in the place of one.
    for joint in model
        .joints
        .iter()
        .copied()
        .filter(|joint| !HANDS.contains(joint) || model.leg_joints(Side::Right)[0] == *joint)
    {
        let range = model.limits[joint];
        angles[joint] = random.between(range.min, range.max);
    }
    angles
}

const HANDS: [Joint; 2] = [Joint::LHand, Joint::RHand];

fn vector(numbers: &[f64]) -> Vec3A {
    Vec3A::new(numbers[0] as f32, numbers[1] as f32, numbers[2] as f32)
}

/// Generates a test for every robot model.
macro_rules! of_each_robot {
    ($($test:ident: $check:ident;)*) => {$(
        #[test]
        fn $test() {
            HUMANOIDS.iter().copied().for_each($check);
        }
    )*};
}

of_each_robot! {
    segments_and_cameras_have_poses_of_kinematics: check_poses;
    inverse_kinematics_reach_poses_of_mujoco: check_inverse;
    masses_equal_those_of_the_kinematics: check_masses;
    joint_ranges_are_those_of_robot_model: check_ranges;
}

fn check_inverse(model: &'static SimulatedModel) {
    let mut random = Random::new(3, 0_u64);
    for _ in 0..30 {
        let mut angles = any_angles(model, &mut random);
        // Beyond, another posture reaches the same pose.
        for joint in [Joint::LHipRoll, Joint::RHipRoll, Joint::LHipPitch, Joint::RHipPitch] {
            angles[joint] = angles[joint].clamp(-1.2, 1.2);
        }
        let data = posed(built(model), &angles);
        let [left, right] = Side::BOTH.map(|side| {
            let body = find(data.model(), MjtObjBase::mjOBJ_BODY, &body_name(Segment::Foot(side))).unwrap();
            let turn = &data.xmat()[body];
            let column = |i: usize| Vec3A::new(turn[i] as f32, turn[3 + i] as f32, turn[6 + i] as f32);
            glam::Affine3A {
                matrix3: glam::Mat3A::from_cols(column(0), column(1), column(2)),
                translation: vector(&data.xpos()[body]),
            }
        });
        let mut found = Joints::all(0.0);
        for (side, leg) in Side::BOTH.into_iter().zip(legs_angles(model, &left, &right, YawFrom::Mean)) {
            leg.write(model, side, &mut found);
        }
        for (side, wanted) in Side::BOTH.into_iter().zip([left, right]) {
            assert!(ankle(model, side, &found).abs_diff_eq(wanted, 2e-4), "{}: {angles:?}", model.name);
        }
    }
}

fn check_poses(model: &'static SimulatedModel) {
    let mut random = Random::new(1, 0_u64);
    for _ in 0..30 {
        let angles = any_angles(model, &mut random);
        let data = posed(built(model), &angles);
        let skeleton = Skeleton::of(model, &angles);
        // A robot without wrists has no body for its hands.
        let has_body =
            |segment: &Segment| !matches!(segment, Segment::Hand(_)) || model.joints.contains(&Joint::LWristYaw);
        for segment in Segment::ALL.into_iter().filter(has_body) {
            let body = find(data.model(), MjtObjBase::mjOBJ_BODY, &body_name(segment)).unwrap();
            let (expected, turn) = (skeleton.pose(segment), &data.xmat()[body]);
            assert!(vector(&data.xpos()[body]).distance(expected.translation) < 1e-5, "{segment:?}");
            let ahead = Vec3A::new(turn[0] as f32, turn[3] as f32, turn[6] as f32);
            assert!(ahead.distance(expected.matrix3.x_axis) < 1e-5, "{segment:?}");
        }
        for (camera, id) in [("Top", CameraId::Top), ("Bottom", CameraId::Bottom)] {
            let camera = find(data.model(), MjtObjBase::mjOBJ_CAMERA, camera).unwrap();
            let (expected, turn) = (skeleton.camera(id), &data.cam_xmat()[camera]);
            assert!(vector(&data.cam_xpos()[camera]).distance(expected.translation) < 1e-5);
            let axis = -Vec3A::new(turn[2] as f32, turn[5] as f32, turn[8] as f32);
            assert!(axis.distance(expected.matrix3.x_axis) < 1e-5);
        }
    }
}

fn check_masses(model: &'static SimulatedModel) {
    let mut random = Random::new(2, 0_u64);
    for _ in 0..30 {
        let angles = any_angles(model, &mut random);
        let mut data = posed(built(model), &angles);
        data.forward();
        let torso = find(data.model(), MjtObjBase::mjOBJ_BODY, "Torso").unwrap();
        let centre = Vec3::from(vector(&data.subtree_com()[torso]));
        assert!(centre.distance(Skeleton::of(model, &angles).centre_of_mass()) < 2e-5, "{centre}");
        assert!((data.model().body_subtreemass()[torso] as f32 - model.total_mass()).abs() < 1e-4);
    }
}

fn check_ranges(model: &'static SimulatedModel) {
    let physics = built(model).physics;
    for &joint in model.joints {
        let id = find(&physics, MjtObjBase::mjOBJ_JOINT, &joint_name(model, joint)).unwrap();
        let [min, max] = physics.jnt_range()[id].map(|end| end as f32);
        let range = model.limits[joint];
        assert!((min - range.min).abs() < 1e-4 && (max - range.max).abs() < 1e-4, "{joint:?}");
    }
}

#[test]
fn no_load_speed_is_near_published_one() {
    let model = built(NAO).physics;
    let physics = Physics { dead_time: 0.0, ..Physics::of(NAO) };
    let end = |far: fn(Joint) -> f32| Joints(Joint::ALL.map(far));
    let (least, most) = (end(|joint| NAO.limits[joint].min), end(|joint| NAO.limits[joint].max));
    let mut motors = Motors::holding(NAO, least, &physics);
    motors.command(NAO, &Command::new(most, 1.0));
    let torques = motors.step(&least, &Joints::all(0.0));
    // The hands are excluded: their speed is between two values published for other models.
    for joint in Joint::ALL.into_iter().filter(|joint| !HANDS.contains(joint)) {
        let id = find(&model, MjtObjBase::mjOBJ_JOINT, &format!("{joint:?}")).unwrap();
        let at = model.jnt_dofadr()[id] as usize;
        let (damping, friction) = (model.dof_damping()[at] as f32, model.dof_frictionloss()[at] as f32);
        let speed = (torques[joint] - friction) / damping;
        let motor = NAO.actuators[joint];
        let share = speed / (motor.no_load_speed / motor.gear_ratio);
        assert!((0.65..1.3).contains(&share), "{joint:?}: {speed} rad/s, {share} of the robot's");
    }
}
