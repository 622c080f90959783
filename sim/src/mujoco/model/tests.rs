//! The MJCF file agrees with the robot model.

use bica_motion::joints::Joints;
use bica_motion::kinematics::Skeleton;
use bica_motion::model::RobotModel;
use bica_motion::robot::Command;
use glam::{Vec3, Vec3A};
use mujoco_rs::prelude::{MjData, MjModel, MjtObjBase};

use super::*;
use crate::TestModel;
use crate::mujoco::motors::Motors;
use crate::setup::Setup;

fn model() -> Model {
    let setup = Setup::default();
    let layout = Layout::new(&setup, &mut Random::new(0, Stream::Start));
    Model::new::<TestModel>(&setup, &layout, &Physics::of::<TestModel>()).unwrap()
}

/// Returns the model with the robot frame at the origin of the field and these angles.
fn posed(model: Model, angles: &Joints) -> MjData<Box<MjModel>> {
    let right = find(&model.physics, MjtObjBase::mjOBJ_JOINT, "RHipYawPitch").unwrap();
    let right = model.physics.jnt_qposadr()[right] as usize;
    let mut data = MjData::new(model.physics);
    data.qpos_mut()[model.torso.position..][..7].copy_from_slice(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    for drive in &model.drives {
        data.qpos_mut()[drive.position] = angles[drive.joint].into();
    }
    data.qpos_mut()[right] = angles[Joint::LHipYawPitch].into();
    data.forward_kinematics();
    data
}

fn any_angles(random: &mut Random) -> Joints {
    let mut angles = Joints::all(0.0);
    for joint in Joint::ALL {
        let range = TestModel::LIMITS[joint];
        angles[joint] = random.between(range.min, range.max);
    }
    // Fingers have mass but are not part of the kinematics.
    (angles[Joint::LHand], angles[Joint::RHand]) = (0.0, 0.0);
    angles
}

fn vector(numbers: &[f64]) -> Vec3A {
    Vec3A::new(numbers[0] as f32, numbers[1] as f32, numbers[2] as f32)
}

#[test]
fn segments_and_cameras_have_poses_of_kinematics() {
    let mut random = Random::new(1, Stream::Start);
    for _ in 0..30 {
        let (angles, model) = (any_angles(&mut random), model());
        let data = posed(model, &angles);
        let skeleton = Skeleton::<TestModel>::of(&angles);
        for segment in Segment::ALL {
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

#[test]
fn masses_equal_those_of_the_kinematics() {
    let mut random = Random::new(2, Stream::Start);
    for _ in 0..30 {
        let angles = any_angles(&mut random);
        let mut data = posed(model(), &angles);
        data.forward();
        let torso = find(data.model(), MjtObjBase::mjOBJ_BODY, "Torso").unwrap();
        let centre = Vec3::from(vector(&data.subtree_com()[torso]));
        assert!(centre.distance(Skeleton::<TestModel>::of(&angles).centre_of_mass()) < 2e-5, "{centre}");
        assert!((data.model().body_subtreemass()[torso] as f32 - TestModel::TOTAL_MASS).abs() < 1e-4);
    }
}

#[test]
fn joint_ranges_are_those_of_robot_model() {
    let model = model().physics;
    for joint in Joint::ALL {
        let id = find(&model, MjtObjBase::mjOBJ_JOINT, &format!("{joint:?}")).unwrap();
        let [min, max] = model.jnt_range()[id].map(|end| end as f32);
        let range = TestModel::LIMITS[joint];
        assert!((min - range.min).abs() < 1e-4 && (max - range.max).abs() < 1e-4, "{joint:?}");
    }
}

#[test]
fn no_load_speed_is_near_published_one() {
    let model = model().physics;
    let physics = Physics { dead_time: 0.0, ..Physics::of::<TestModel>() };
    let end = |far: fn(Joint) -> f32| Joints(Joint::ALL.map(far));
    let (least, most) = (end(|joint| TestModel::LIMITS[joint].min), end(|joint| TestModel::LIMITS[joint].max));
    let mut motors = Motors::holding::<TestModel>(least, &physics);
    motors.command::<TestModel>(&Command::new(most, 1.0));
    let torques = motors.step(&least);
    // The speed of the hands is between two values published for other models.
    let hands = [Joint::LHand, Joint::RHand];
    for joint in Joint::ALL.into_iter().filter(|joint| !hands.contains(joint)) {
        let id = find(&model, MjtObjBase::mjOBJ_JOINT, &format!("{joint:?}")).unwrap();
        let at = model.jnt_dofadr()[id] as usize;
        let (damping, friction) = (model.dof_damping()[at] as f32, model.dof_frictionloss()[at] as f32);
        let speed = (torques[joint] - friction) / damping;
        let motor = TestModel::ACTUATORS[joint];
        let share = speed / (motor.no_load_speed / motor.gear_ratio);
        assert!((0.65..1.3).contains(&share), "{joint:?}: {speed} rad/s, {share} of the robot's");
    }
}
