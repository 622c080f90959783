//! Forward kinematics: poses of all segments from joint angles.

use glam::{Affine3A, Vec3};

use crate::joints::{Joint, Joints};
use crate::model::{ArmGeometry, CameraMount, RobotModel};
use crate::robot::CameraId;
use crate::segment::{SEGMENTS, Segment};
use crate::side::Side;

/// Poses of all segments in the robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skeleton {
    model: &'static RobotModel,
    poses: [Affine3A; SEGMENTS],
}

impl Skeleton {
    /// Skeleton at joint angles, rad. Angles beyond the limits are not clamped; NaN propagates.
    #[must_use]
    pub fn of(model: &'static RobotModel, angles: &Joints) -> Self {
        let mut poses = [Affine3A::IDENTITY; SEGMENTS];
        poses[1..3].copy_from_slice(&head(model, angles));
        poses[3..8].copy_from_slice(&arm(model, Side::Left, angles));
        poses[8..13].copy_from_slice(&arm(model, Side::Right, angles));
        poses[13..19].copy_from_slice(&leg(model, Side::Left, angles));
        poses[19..].copy_from_slice(&leg(model, Side::Right, angles));
        Self { model, poses }
    }

    /// Pose of a segment in the robot frame: the frame of the joint that moves it.
    #[must_use]
    pub fn pose(&self, segment: Segment) -> Affine3A {
        self.poses[segment.index()]
    }

    /// Pose of a sole in the robot frame.
    #[must_use]
    pub fn sole(&self, side: Side) -> Affine3A {
        sole(self.model, self.pose(Segment::Foot(side)))
    }

    /// Pose of a camera in the robot frame: x along the optical axis.
    #[must_use]
    pub fn camera(&self, camera: CameraId) -> Affine3A {
        self::camera(self.model, self.pose(Segment::Head), camera)
    }

    /// Centre of mass of the whole body in the robot frame, m.
    #[must_use]
    pub fn centre_of_mass(&self) -> Vec3 {
        let moment: Vec3 = Segment::ALL
            .into_iter()
            .map(|segment| {
                let own = self.model.masses.of(segment);
                own.mass * self.pose(segment).transform_point3(own.centre)
            })
            .sum();
        moment / self.model.total_mass()
    }
}

/// Neck and head.
pub(super) fn head(model: &RobotModel, angles: &Joints) -> [Affine3A; 2] {
    let neck = at(model.dimensions.neck) * yaw(angles[Joint::HeadYaw]);
    [neck, neck * pitch(angles[Joint::HeadPitch])]
}

/// Shoulder, biceps, elbow, forearm, hand.
pub(super) fn arm(model: &RobotModel, side: Side, angles: &Joints) -> [Affine3A; 5] {
    if let ArmGeometry::Sideways(arm) = model.arm {
        return arm.poses(side, on(side, model.dimensions.shoulder), side.arm().map(|joint| angles[joint]));
    }
    let [shoulder_pitch, shoulder_roll, elbow_yaw, elbow_roll, wrist_yaw] =
        [0, 1, 2, 3, 4].map(|i| angles[side.arm()[i]]);
    let shoulder = at(on(side, model.dimensions.shoulder)) * pitch(shoulder_pitch);
    let biceps = shoulder * yaw(shoulder_roll);
    let elbow = biceps * at(on(side, model.dimensions.upper_arm)) * roll(elbow_yaw);
    let forearm = elbow * yaw(elbow_roll);
    let hand = forearm * at(model.dimensions.lower_arm) * roll(wrist_yaw);
    [shoulder, biceps, elbow, forearm, hand]
}

/// Pelvis, hip, thigh, tibia, ankle, foot.
pub(super) fn leg(model: &RobotModel, side: Side, angles: &Joints) -> [Affine3A; 6] {
    model.leg_poses(side, model.leg_joints(side).map(|joint| angles[joint]))
}

/// The sole under a foot.
pub(super) fn sole(model: &RobotModel, foot: Affine3A) -> Affine3A {
    foot * at(Vec3::new(0.0, 0.0, -model.dimensions.foot_height))
}

/// A camera in the head.
pub(super) fn camera(model: &RobotModel, head: Affine3A, camera: CameraId) -> Affine3A {
    let CameraMount { position, tilt, .. } = model.dimensions.camera(camera);
    head * at(position) * pitch(tilt)
}

fn on(side: Side, left: Vec3) -> Vec3 {
    Vec3::new(left.x, side.sign() * left.y, left.z)
}

fn at(place: Vec3) -> Affine3A {
    Affine3A::from_translation(place)
}

fn roll(angle: f32) -> Affine3A {
    Affine3A::from_rotation_x(angle)
}

fn pitch(angle: f32) -> Affine3A {
    Affine3A::from_rotation_y(angle)
}

fn yaw(angle: f32) -> Affine3A {
    Affine3A::from_rotation_z(angle)
}
