//! The tables of the NAO against numbers copied from the sources that they cite.

use bica_motion::joints::Joint;
use bica_motion::model::{Actuator, Nao, RobotModel};
use bica_motion::segment::Segment;
use bica_motion::side::Side;
use glam::Vec3;

/// No-load speed in rpm, stall and continuous torque in mNm, gear ratio (Aldebaran, rUNSWift 2019).
fn motor(joint: Joint) -> (f32, f32, f32, f32) {
    let name = format!("{joint:?}");
    match name.trim_start_matches(['L', 'R']) {
        "HeadYaw" | "ElbowYaw" => (10_700.0, 14.3, 6.2, 150.27),
        "HeadPitch" | "ShoulderRoll" | "ElbowRoll" => (10_700.0, 14.3, 6.2, 173.22),
        "ShoulderPitch" => (11_400.0, 22.4, 2.6, 150.27),
        "WristYaw" => (8400.0, 9.4, 4.9, 50.61),
        "Hand" => (8400.0, 9.4, 4.9, 36.24),
        "HipYawPitch" | "HipRoll" | "AnkleRoll" => (8700.0, 65.0, 17.8, 201.3),
        "HipPitch" | "KneePitch" | "AnklePitch" => (8700.0, 65.0, 17.8, 130.85),
        other => panic!("{other}"),
    }
}

#[test]
fn motors_are_those_of_the_data_sheet() {
    for joint in Joint::ALL {
        let (rpm, stall, continuous, gear) = motor(joint);
        let Actuator { no_load_speed, stall_torque, continuous_torque, gear_ratio, voltage, gear_efficiency } =
            Nao::ACTUATORS[joint];
        assert!((no_load_speed - rpm * std::f32::consts::TAU / 60.0).abs() < 1e-3, "{joint:?}");
        assert!((stall_torque - 1e-3 * stall).abs() < 1e-8, "{joint:?}");
        assert!((continuous_torque - 1e-3 * continuous).abs() < 1e-8, "{joint:?}");
        assert_eq!((gear_ratio, voltage, gear_efficiency), (gear, 21.6, 0.8), "{joint:?}");
    }
}

#[test]
fn the_knee_motor_has_the_published_characteristics() {
    let knee = Nao::ACTUATORS[Joint::LKneePitch];
    // No-load speed behind the gear: rUNSWift 2019 `bodyV6.cpp`, 8700 rpm / 130.85.
    assert!((knee.no_load_speed / knee.gear_ratio - 6.96).abs() < 0.01);
    assert!((Nao::CONTINUOUS_CURRENTS[Joint::LKneePitch] - 0.75).abs() < 0.01);
    assert!((knee.current(2.48) - 1.0).abs() < 0.01 && (knee.current(-2.48) - 1.0).abs() < 0.01);
    assert!((knee.resistance() - 7.9).abs() < 0.05);
}

/// Left segments: mass, g, and centre of mass, mm (B-Human 2023).
const MASSES: [(Segment, [f32; 4]); 14] = [
    (Segment::Torso, [1049.60, -4.13, 0.0, 128.42]),
    (Segment::Neck, [78.42, -0.01, 0.0, -27.42]),
    (Segment::Head, [659.37, 1.09, 1.46, 57.19]),
    (Segment::Shoulder(Side::Left), [93.04, -1.65, -26.63, 0.14]),
    (Segment::Biceps(Side::Left), [157.77, 24.55, 5.63, 3.30]),
    (Segment::Elbow(Side::Left), [64.83, -27.44, 0.0, -0.14]),
    (Segment::Forearm(Side::Left), [77.61, 25.56, 2.81, 0.76]),
    (Segment::Hand(Side::Left), [185.33, 34.34, -0.88, 3.08]),
    (Segment::Pelvis(Side::Left), [69.81, -7.81, -11.14, 26.61]),
    (Segment::Hip(Side::Left), [140.53, -15.49, 0.29, -5.15]),
    (Segment::Thigh(Side::Left), [389.68, 1.38, 2.21, -53.73]),
    (Segment::Tibia(Side::Left), [301.42, 4.53, 2.25, -49.36]),
    (Segment::Ankle(Side::Left), [134.16, 0.45, 0.29, 6.85]),
    (Segment::Foot(Side::Left), [171.84, 25.42, 3.30, -32.39]),
];

#[test]
fn masses_are_those_published_and_mirrored() {
    for (segment, [mass, x, y, z]) in MASSES {
        let own = Nao::MASSES.of(segment);
        assert!((own.mass - 1e-3 * mass).abs() < 1e-7, "{segment:?}");
        assert!((own.centre - 1e-3 * Vec3::new(x, y, z)).length() < 1e-7, "{segment:?}");
        let right = match segment {
            Segment::Shoulder(_) => Segment::Shoulder(Side::Right),
            Segment::Hand(_) => Segment::Hand(Side::Right),
            Segment::Thigh(_) => Segment::Thigh(Side::Right),
            Segment::Foot(_) => Segment::Foot(Side::Right),
            _ => continue,
        };
        let mirrored = Nao::MASSES.of(right);
        assert!((mirrored.centre - 1e-3 * Vec3::new(x, -y, z)).length() < 1e-7, "{right:?}");
    }
    assert!((Nao::TOTAL_MASS - 5.359_43).abs() < 1e-5, "{}", Nao::TOTAL_MASS);
}

#[test]
fn lengths_are_those_published() {
    let it = Nao::DIMENSIONS;
    let lengths = [it.hip.y, it.thigh, it.tibia, it.foot_height, it.neck.z, it.shoulder.y, it.shoulder.z];
    let published = [0.05_f32, 0.1, 0.1029, 0.045_19, 0.2115, 0.098, 0.185];
    assert_eq!(lengths.map(f32::to_bits), published.map(f32::to_bits));
    assert!((it.leg_length() - 0.248_09).abs() < 1e-6);
    assert_eq!(it.top_camera.position, Vec3::new(0.058_71, 0.0, 0.063_64));
    assert_eq!(it.bottom_camera.position, Vec3::new(0.050_71, 0.0, 0.017_74));
    let tilts = [it.top_camera.tilt, it.bottom_camera.tilt].map(f32::to_degrees);
    assert!((tilts[0] - 1.2).abs() < 1e-5 && (tilts[1] - 39.7).abs() < 1e-5, "{tilts:?}");
    let focal = it.top_camera.focal * glam::Vec2::new(640.0, 480.0);
    assert!((focal - glam::Vec2::new(618.66, 617.16)).length() < 1e-3, "{focal}");
}

#[test]
fn tuned_motions_are_the_recorded_ones() {
    let (kinematic, dynamic) = (Nao::KINEMATIC_PROFILE, Nao::DYNAMIC_PROFILE);
    assert_eq!(
        (kinematic.gait.hip_height, kinematic.gait.step_duration, kinematic.gait.pendulum_height),
        (0.215, 0.28, 0.0)
    );
    assert_eq!(
        (dynamic.gait.hip_height, dynamic.gait.step_duration, dynamic.gait.pendulum_height),
        (0.235, 0.25, 0.26)
    );
    assert_eq!(dynamic.odometry.commanded_scale, glam::Vec2::new(1.14, 1.05));
    let lengths = [&kinematic.kicks, &dynamic.kicks]
        .map(|kicks| [kicks.front, kicks.diagonal, kicks.lateral].map(|kick| kick.frames.len()));
    assert_eq!(lengths, [[7, 8, 7], [7, 8, 7]]);
    let get_up = Nao::GET_UP;
    assert_eq!((get_up.sit_up_from_front.len(), get_up.sit_up_from_back.len(), get_up.rise.len()), (14, 4, 10));
}
