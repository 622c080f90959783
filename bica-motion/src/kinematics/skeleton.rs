//! Forward kinematics: from joint angles to the poses of all parts.

use core::f32::consts::FRAC_PI_4;

use glam::{Affine3A, Vec3};

use crate::dimensions::{
    BOTTOM_CAMERA, BOTTOM_CAMERA_TILT, FOOT_HEIGHT, HIP, LOWER_ARM, NECK, SHOULDER, THIGH, TIBIA, TOP_CAMERA,
    TOP_CAMERA_TILT, UPPER_ARM,
};
use crate::joints::{Joint, Joints};
use crate::kinematics::segment::{SEGMENTS, Segment};
use crate::masses::{TOTAL_MASS, mass};
use crate::robot::CameraId;
use crate::side::Side;

/// The pose of every part of the body in the robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skeleton([Affine3A; SEGMENTS]);

impl Skeleton {
    /// The body with these joint angles, rad. Angles beyond the limits and such that are no numbers go straight
    /// through the formulas.
    #[must_use]
    pub fn of(angles: &Joints) -> Self {
        let mut poses = [Affine3A::IDENTITY; SEGMENTS];
        poses[1..3].copy_from_slice(&head(angles));
        poses[3..8].copy_from_slice(&arm(Side::Left, angles));
        poses[8..13].copy_from_slice(&arm(Side::Right, angles));
        poses[13..19].copy_from_slice(&leg(Side::Left, angles));
        poses[19..].copy_from_slice(&leg(Side::Right, angles));
        Self(poses)
    }

    /// A part's pose in the robot frame: the frame of the joint that moves it.
    #[must_use]
    pub fn pose(&self, segment: Segment) -> Affine3A {
        self.0[segment.index()]
    }

    /// The pose of a sole in the robot frame.
    #[must_use]
    pub fn sole(&self, side: Side) -> Affine3A {
        sole(self.pose(Segment::Foot(side)))
    }

    /// The pose of a camera in the robot frame: x along the optical axis.
    #[must_use]
    pub fn camera(&self, camera: CameraId) -> Affine3A {
        self::camera(self.pose(Segment::Head), camera)
    }

    /// The whole body's centre of mass in the robot frame, m.
    #[must_use]
    pub fn centre_of_mass(&self) -> Vec3 {
        let moment: Vec3 = Segment::ALL
            .into_iter()
            .map(|segment| {
                let own = mass(segment);
                own.mass * self.pose(segment).transform_point3(own.centre)
            })
            .sum();
        moment / TOTAL_MASS
    }
}

/// Neck and head.
pub(super) fn head(angles: &Joints) -> [Affine3A; 2] {
    let neck = at(NECK) * yaw(angles[Joint::HeadYaw]);
    [neck, neck * pitch(angles[Joint::HeadPitch])]
}

/// Shoulder, biceps, elbow, forearm, hand.
pub(super) fn arm(side: Side, angles: &Joints) -> [Affine3A; 5] {
    let [shoulder_pitch, shoulder_roll, elbow_yaw, elbow_roll, wrist_yaw] =
        [0, 1, 2, 3, 4].map(|i| angles[side.arm()[i]]);
    let shoulder = at(on(side, SHOULDER)) * pitch(shoulder_pitch);
    let biceps = shoulder * yaw(shoulder_roll);
    let elbow = biceps * at(on(side, UPPER_ARM)) * roll(elbow_yaw);
    let forearm = elbow * yaw(elbow_roll);
    let hand = forearm * at(LOWER_ARM) * roll(wrist_yaw);
    [shoulder, biceps, elbow, forearm, hand]
}

/// Pelvis, hip, thigh, tibia, ankle, foot.
pub(super) fn leg(side: Side, angles: &Joints) -> [Affine3A; 6] {
    let [yaw_pitch, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll] = side.leg().map(|joint| angles[joint]);
    let tilt = side.sign() * FRAC_PI_4;
    let pelvis = at(on(side, HIP)) * roll(tilt) * yaw(-side.sign() * yaw_pitch) * roll(-tilt);
    let hip = pelvis * roll(hip_roll);
    let thigh = hip * pitch(hip_pitch);
    let tibia = thigh * at(Vec3::new(0.0, 0.0, -THIGH)) * pitch(knee);
    let ankle = tibia * at(Vec3::new(0.0, 0.0, -TIBIA)) * pitch(ankle_pitch);
    [pelvis, hip, thigh, tibia, ankle, ankle * roll(ankle_roll)]
}

/// The sole under a foot.
pub(super) fn sole(foot: Affine3A) -> Affine3A {
    foot * at(Vec3::new(0.0, 0.0, -FOOT_HEIGHT))
}

/// The camera in a head.
pub(super) fn camera(head: Affine3A, camera: CameraId) -> Affine3A {
    let (place, tilt) = match camera {
        CameraId::Top => (TOP_CAMERA, TOP_CAMERA_TILT),
        CameraId::Bottom => (BOTTOM_CAMERA, BOTTOM_CAMERA_TILT),
    };
    head * at(place) * pitch(tilt)
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
