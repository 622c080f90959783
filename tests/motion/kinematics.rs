//! Kinematics against published numbers and an independent f64 reference; inverse against forward kinematics.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{self, LegAngles, Segment, Skeleton, YawFrom, ground_from_robot, legs_angles};
use bica_motion::model::{NAO, RobotModel};
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use glam::{Affine3A, Mat3A, Vec3};
use proptest::prelude::*;
use std::f32::consts::{FRAC_PI_2, PI};

/// Poses computed with 4×4 matrices in f64, from the joint tables and independent of the tested code.
mod reference {
    use bica_motion::joints::{Joint, Joints};
    use bica_motion::side::Side;

    pub(crate) type Matrix = [[f64; 4]; 4];

    pub(crate) fn multiply(a: Matrix, b: Matrix) -> Matrix {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
    }

    pub(crate) fn chain(parts: &[Matrix]) -> Matrix {
        parts.iter().copied().reduce(multiply).expect("a chain has parts")
    }

    pub(crate) fn shift(x: f64, y: f64, z: f64) -> Matrix {
        [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]]
    }

    /// Rodrigues' formula about any axis through the origin.
    pub(crate) fn turn(axis: [f64; 3], angle: f64) -> Matrix {
        let n = axis.iter().map(|a| a * a).sum::<f64>().sqrt();
        let [x, y, z] = axis.map(|a| a / n);
        let (s, c) = angle.sin_cos();
        let v = 1.0 - c;
        [
            [c + x * x * v, x * y * v - z * s, x * z * v + y * s, 0.0],
            [y * x * v + z * s, c + y * y * v, y * z * v - x * s, 0.0],
            [z * x * v - y * s, z * y * v + x * s, c + z * z * v, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    }

    pub(crate) fn foot(side: Side, angles: &Joints) -> Matrix {
        let q = side.leg().map(|joint| f64::from(angles[joint]));
        let s = f64::from(side.sign());
        let y = [0.0, 1.0, 0.0];
        let x = [1.0, 0.0, 0.0];
        chain(&[
            shift(0.0, s * 0.05, 0.0),
            turn([0.0, 1.0, -s], q[0]),
            turn(x, q[1]),
            turn(y, q[2]),
            shift(0.0, 0.0, -0.1),
            turn(y, q[3]),
            shift(0.0, 0.0, -0.1029),
            turn(y, q[4]),
            turn(x, q[5]),
        ])
    }

    pub(crate) fn camera(angles: &Joints, x: f64, z: f64, tilt_degrees: f64) -> Matrix {
        chain(&[
            shift(0.0, 0.0, 0.2115),
            turn([0.0, 0.0, 1.0], f64::from(angles[Joint::HeadYaw])),
            turn([0.0, 1.0, 0.0], f64::from(angles[Joint::HeadPitch])),
            shift(x, 0.0, z),
            turn([0.0, 1.0, 0.0], tilt_degrees.to_radians()),
        ])
    }

    pub(crate) fn hand(side: Side, angles: &Joints) -> Matrix {
        let q = side.arm().map(|joint| f64::from(angles[joint]));
        let s = f64::from(side.sign());
        chain(&[
            shift(0.0, s * 0.098, 0.185),
            turn([0.0, 1.0, 0.0], q[0]),
            turn([0.0, 0.0, 1.0], q[1]),
            shift(0.105, s * 0.015, 0.0),
            turn([1.0, 0.0, 0.0], q[2]),
            turn([0.0, 0.0, 1.0], q[3]),
            shift(0.055_95, 0.0, 0.0),
            turn([1.0, 0.0, 0.0], q[4]),
        ])
    }
}

fn difference(pose: &Affine3A, reference: reference::Matrix) -> f64 {
    let columns = [pose.matrix3.x_axis, pose.matrix3.y_axis, pose.matrix3.z_axis, pose.translation];
    let mut most = 0.0_f64;
    for (j, column) in columns.iter().enumerate() {
        for (i, value) in column.to_array().iter().enumerate() {
            most = most.max((f64::from(*value) - reference[i][j]).abs());
        }
    }
    most
}

pub(crate) fn distance(a: &Affine3A, b: &Affine3A) -> f32 {
    let turn = |m: Mat3A, n: Mat3A| (m - n).to_cols_array().into_iter().fold(0.0_f32, |most, v| most.max(v.abs()));
    (a.translation - b.translation).length().max(turn(a.matrix3, b.matrix3))
}

/// Any angles within the limits.
pub(crate) fn any_angles(model: &'static RobotModel) -> impl Strategy<Value = Joints> {
    prop::array::uniform25(0.0_f32..=1.0).prop_map(|shares| {
        let mut angles = Joints::all(0.0);
        for joint in Joint::ALL {
            let range = model.limits[joint];
            angles[joint] = range.min + (range.max - range.min) * shares[joint.index()];
        }
        angles
    })
}

/// Random angles within the limits whose knees do not bend backwards, so that the inverse kinematics can return them.
fn any_bent_angles() -> impl Strategy<Value = Joints> {
    any_angles(NAO).prop_map(|mut angles| {
        for joint in [Joint::LKneePitch, Joint::RKneePitch] {
            angles[joint] = angles[joint].max(0.0);
        }
        angles
    })
}

/// Distance of a hip from the roll axis of its foot, m. On the axis, the yaw-pitch angle is not unique.
fn off_roll_axis(side: Side, foot: &Affine3A) -> f32 {
    let hip = foot.inverse().transform_point3(Vec3::new(0.0, side.sign() * 0.05, 0.0));
    hip.y.hypot(hip.z)
}

/// Rows of the published table: ankle x, foot yaw; hip yaw-pitch, hip roll, hip pitch, knee, ankle pitch, ankle roll.
const STANDS: [[f32; 8]; 4] = [
    [0.0, 0.0, 0.0, 0.0, -0.43200, 0.85104, -0.41904, 0.0],
    [-0.012, 0.0, 0.0, 0.0, -0.36241, 0.84170, -0.47929, 0.0],
    [0.020, 0.0, 0.0, 0.0, -0.52650, 0.82489, -0.29839, 0.0],
    [-0.012, 0.2, -0.27574, 0.03239, -0.16996, 0.84170, -0.47800, -0.01290],
];

fn flat_foot(side: Side, x: f32, outward: f32) -> Affine3A {
    let place = Vec3::new(x, side.sign() * 0.05, NAO.dimensions.foot_height - 0.230);
    Affine3A::from_translation(place) * Affine3A::from_rotation_z(side.sign() * outward)
}

fn row(side: Side, row: [f32; 8]) -> LegAngles {
    LegAngles {
        hip_yaw_pitch: row[2],
        hip_roll: side.sign() * row[3],
        hip_pitch: row[4],
        knee_pitch: row[5],
        ankle_pitch: row[6],
        ankle_roll: side.sign() * row[7],
    }
}

fn array(leg: &LegAngles) -> [f32; 6] {
    [leg.hip_yaw_pitch, leg.hip_roll, leg.hip_pitch, leg.knee_pitch, leg.ankle_pitch, leg.ankle_roll]
}

fn assert_close(found: &LegAngles, expected: &LegAngles, tolerance: f32) {
    for (a, b) in array(found).into_iter().zip(array(expected)) {
        assert!((a - b).abs() < tolerance, "{found:?} is not {expected:?}");
    }
}

#[test]
fn inverse_kinematics_agree_with_the_published_stands() {
    for values in STANDS {
        let [left, right] = Side::BOTH.map(|side| flat_foot(side, values[0], values[1]));
        for (side, foot) in [(Side::Left, left), (Side::Right, right)] {
            let expected = row(side, values);
            assert_close(&NAO.leg_angles(side, &foot), &expected, 1e-5);
            assert_close(&NAO.leg_angles_at(side, &foot, values[2]), &expected, 2e-5);
            assert_close(&legs_angles(NAO, &left, &right, YawFrom::Mean)[side.index()], &expected, 2e-5);
        }
    }
}

fn standing() -> Joints {
    let mut angles = Joints::all(0.0);
    for side in Side::BOTH {
        row(side, STANDS[1]).write(NAO, side, &mut angles);
        angles[side.arm()[0]] = FRAC_PI_2;
        angles[side.arm()[1]] = side.sign() * 7.0_f32.to_radians();
    }
    angles
}

#[test]
fn the_centre_of_mass_is_the_published_one() {
    assert!((NAO.total_mass() - 5.359_43).abs() < 1e-5, "{}", NAO.total_mass());
    for (angles, expected) in [
        (Joints::all(0.0), Vec3::new(0.021_22, 0.000_18, 0.052_18)),
        (standing(), Vec3::new(0.003_86, 0.000_18, 0.035_38)),
    ] {
        let found = kinematics::centre_of_mass(NAO, &angles);
        assert!((found - expected).abs().max_element() < 1e-5, "{found} is not {expected}");
    }
}

#[test]
fn camera_poses_are_the_published_ones() {
    // Height of the camera above the ground, m; pixel, and the ground point that it shows, m, robot frame (intrinsics
    // of B-Human and HULKs).
    let (f, centre) = ((618.66, 617.16), (320.0, 240.0));
    let table = [
        (CameraId::Top, 0.505_14, (320.0, 240.0), (24.174, 0.0)),
        (CameraId::Top, 0.505_14, (320.0, 479.0), (1.286, 0.0)),
        (CameraId::Top, 0.505_14, (500.0, 400.0), (1.852, -0.525)),
        (CameraId::Bottom, 0.459_24, (320.0, 240.0), (0.604, 0.0)),
        (CameraId::Bottom, 0.459_24, (320.0, 479.0), (0.307, 0.0)),
        (CameraId::Bottom, 0.459_24, (500.0, 400.0), (0.3815, -0.159)),
    ];
    for (id, height, pixel, expected) in table {
        let camera = kinematics::camera(NAO, id, &Joints::all(0.0));
        let above = camera.translation.z + 0.230;
        assert!((above - height).abs() < 1e-5, "{above} is not {height}");
        let ray = Vec3::new(1.0, -(pixel.0 - centre.0) / f.0, -(pixel.1 - centre.1) / f.1);
        let ray = camera.transform_vector3(ray);
        let hit = Vec3::from(camera.translation) - ray * (above / ray.z);
        let near = 1e-3 * f32::max(expected.0, 1.0);
        assert!((hit.x - expected.0).abs() < near && (hit.y - expected.1).abs() < near, "{hit} is not {expected:?}");
    }
}

#[test]
fn the_ground_lies_between_the_feet_in_stand() {
    for support in Side::BOTH {
        let ground = ground_from_robot(NAO, support, &standing());
        let expected = Affine3A::from_translation(Vec3::new(0.012, 0.0, 0.230));
        assert!(distance(&ground, &expected) < 2e-6, "{ground:?}");
    }
}

#[test]
fn target_out_of_reach_gives_the_straight_leg() {
    let far = Affine3A::from_translation(Vec3::new(0.3, 0.05, -0.4));
    let leg = NAO.leg_angles(Side::Left, &far);
    assert!(leg.knee_pitch.abs() < 1e-6);
    let mut angles = Joints::all(0.0);
    leg.write(NAO, Side::Left, &mut angles);
    let reached = kinematics::ankle(NAO, Side::Left, &angles).translation - glam::Vec3A::new(0.0, 0.05, 0.0);
    assert!((reached.normalize() - glam::Vec3A::new(0.6, 0.0, -0.8)).length() < 1e-6, "{reached}");
}

proptest! {
    #![proptest_config(crate::motion::cases(1000))]

    #[test]
    fn forward_kinematics_agree_with_an_f64_reference(angles in any_angles(NAO)) {
        let skeleton = Skeleton::of(NAO, &angles);
        for side in Side::BOTH {
            let foot = reference::foot(side, &angles);
            prop_assert!(difference(&kinematics::ankle(NAO, side, &angles), foot) < 1e-6);
            let sole = reference::multiply(foot, reference::shift(0.0, 0.0, -0.045_19));
            prop_assert!(difference(&kinematics::sole(NAO, side, &angles), sole) < 1e-6);
            prop_assert!(difference(&skeleton.sole(side), sole) < 1e-6);
            prop_assert!(difference(&skeleton.pose(Segment::Hand(side)), reference::hand(side, &angles)) < 1e-6);
        }
        let top = reference::camera(&angles, 0.058_71, 0.063_64, 1.2);
        let bottom = reference::camera(&angles, 0.050_71, 0.017_74, 39.7);
        prop_assert!(difference(&kinematics::camera(NAO, CameraId::Top, &angles), top) < 1e-6);
        prop_assert!(difference(&skeleton.camera(CameraId::Bottom), bottom) < 1e-6);
    }

    #[test]
    fn inverse_kinematics_of_one_leg_are_inverse(angles in any_bent_angles()) {
        for side in Side::BOTH {
            let expected = kinematics::ankle(NAO, side, &angles);
            let mut found = Joints::all(0.0);
            NAO.leg_angles(side, &expected).write(NAO, side, &mut found);
            let reached = kinematics::ankle(NAO, side, &found);
            prop_assert!(distance(&reached, &expected) < 1e-5, "{} off", distance(&reached, &expected));
        }
    }

    #[test]
    fn inverse_kinematics_of_both_legs_are_inverse(angles in any_bent_angles()) {
        let [left, right] = Side::BOTH.map(|side| kinematics::ankle(NAO, side, &angles));
        prop_assume!(off_roll_axis(Side::Left, &left) > 0.03 && off_roll_axis(Side::Right, &right) > 0.03);
        for yaw in [YawFrom::Mean, YawFrom::Leg(Side::Left), YawFrom::Leg(Side::Right)] {
            let mut found = Joints::all(0.0);
            for (side, leg) in Side::BOTH.into_iter().zip(legs_angles(NAO, &left, &right, yaw)) {
                leg.write(NAO, side, &mut found);
            }
            for (side, expected) in [(Side::Left, left), (Side::Right, right)] {
                let reached = kinematics::ankle(NAO, side, &found);
                prop_assert!(distance(&reached, &expected) < 1e-5, "{} off", distance(&reached, &expected));
            }
        }
    }

    #[test]
    fn a_given_yaw_pitch_changes_only_the_yaw_of_the_foot(angles in any_bent_angles(), other in -1.1_f32..0.7) {
        for side in Side::BOTH {
            let expected = kinematics::ankle(NAO, side, &angles);
            let mut found = Joints::all(0.0);
            NAO.leg_angles_at(side, &expected, other).write(NAO, side, &mut found);
            let reached = kinematics::ankle(NAO, side, &found);
            prop_assert!((reached.translation - expected.translation).length() < 1e-5);
            prop_assert!((reached.matrix3.z_axis - expected.matrix3.z_axis).length() < 1e-5);
        }
    }

    #[test]
    fn a_mirrored_posture_has_mirrored_poses(angles in any_angles(NAO)) {
        let mirrored = angles.mirrored();
        prop_assert_eq!(mirrored.mirrored(), angles);
        let (here, there) = (Skeleton::of(NAO, &angles), Skeleton::of(NAO, &mirrored));
        for side in Side::BOTH {
            for (a, b) in [
                (here.sole(side), there.sole(side.other())),
                (here.pose(Segment::Hand(side)), there.pose(Segment::Hand(side.other()))),
            ] {
                let flipped = Vec3::new(a.translation.x, -a.translation.y, a.translation.z);
                prop_assert!((flipped - Vec3::from(b.translation)).length() < 1e-6);
            }
        }
    }

    #[test]
    fn the_support_sole_lies_flat_on_the_ground(angles in any_angles(NAO)) {
        for support in Side::BOTH {
            let ground = ground_from_robot(NAO, support, &angles);
            let [own, other] = [support, support.other()].map(|side| ground * kinematics::sole(NAO, side, &angles));
            prop_assert!(own.translation.z.abs() < 1e-6);
            prop_assert!((own.matrix3.z_axis - glam::Vec3A::Z).length() < 1e-6);
            let middle = own.translation + other.translation;
            prop_assert!(middle.x.abs() < 1e-6 && middle.y.abs() < 1e-6, "{middle}");
            let heading = |pose: &Affine3A| pose.matrix3.x_axis.y.atan2(pose.matrix3.x_axis.x);
            let sum = heading(&own) + heading(&other);
            prop_assert!(sum.abs() < 1e-4 || (sum.abs() - 2.0 * PI).abs() < 1e-4, "{sum}");
        }
    }
}
