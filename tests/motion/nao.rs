//! The tables of the NAO against numbers copied from the sources that they cite.

use bica_motion::joints::Joint;
use bica_motion::model::{Actuator, NAO};

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
            NAO.actuators[joint];
        assert!((no_load_speed - rpm * std::f32::consts::TAU / 60.0).abs() < 1e-3, "{joint:?}");
        assert!((stall_torque - 1e-3 * stall).abs() < 1e-8, "{joint:?}");
        assert!((continuous_torque - 1e-3 * continuous).abs() < 1e-8, "{joint:?}");
        assert_eq!((gear_ratio, voltage, gear_efficiency), (gear, 21.6, 0.8), "{joint:?}");
    }
}

#[test]
fn the_knee_motor_has_the_published_characteristics() {
    let knee = NAO.actuators[Joint::LKneePitch];
    // No-load speed behind the gear: rUNSWift 2019 `bodyV6.cpp`, 8700 rpm / 130.85.
    assert!((knee.no_load_speed / knee.gear_ratio - 6.96).abs() < 0.01);
    assert!((NAO.continuous_current(Joint::LKneePitch) - 0.75).abs() < 0.01);
    assert!((knee.current(2.48) - 1.0).abs() < 0.01 && (knee.current(-2.48) - 1.0).abs() < 0.01);
    assert!((knee.resistance() - 7.9).abs() < 0.05);
}
