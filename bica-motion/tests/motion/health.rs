//! A body that fails in parts.

use bica_motion::health::{Fault, Health};
use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use bica_motion::stand::{STAND, Stiffness};
use glam::Vec3;

/// What a standing robot senses in a cycle; its inertial unit is noisy.
fn standing(cycle: u32) -> Sensors<'static> {
    let foot = FootPressure { front_left: 26.0, ..FootPressure::default() };
    let noise = 1e-3 * (cycle % 7) as f32;
    Sensors {
        angles: STAND,
        inertial: Inertial { gyro: Vec3::splat(noise), acceleration: Vec3::Z * 9.81, roll: 0.0, pitch: 0.0 },
        left_foot: foot,
        right_foot: foot,
        buttons: Buttons::default(),
        image: None,
    }
}

/// What is found in `cycles` when each one's sensors are changed so, and after how many.
fn found(cycles: u32, targets: &Joints, change: impl Fn(&mut Sensors<'_>)) -> Option<(Fault, u32)> {
    let mut health = Health::new();
    let stiffness = Stiffness::Walk.joints();
    (0..cycles).find_map(|cycle| {
        let mut sensors = standing(cycle);
        change(&mut sensors);
        health.step(&sensors, targets, &stiffness);
        health.fault().map(|fault| (fault, cycle))
    })
}

#[test]
fn a_sound_body_has_no_fault() {
    assert_eq!(found(2000, &STAND, |_| ()), None);
}

#[test]
fn a_joint_that_does_not_follow_is_found_within_two_seconds() {
    let mut targets = STAND;
    targets[Joint::RKneePitch] += 0.9;
    let (fault, cycle) = found(2000, &targets, |_| ()).expect("it is found");
    assert_eq!(fault, Fault::Stuck(Joint::RKneePitch));
    assert!((90..200).contains(&cycle), "{cycle}");
    targets[Joint::RKneePitch] = STAND[Joint::RKneePitch] + 0.3;
    assert_eq!(found(2000, &targets, |_| ()), None, "motors give way a little");
    let mut arms = STAND;
    arms[Joint::LShoulderPitch] -= 1.0;
    assert_eq!(found(2000, &arms, |_| ()), None, "arms are soft");
}

#[test]
fn a_silent_inertial_unit_is_found() {
    let (fault, _) = found(2000, &STAND, |sensors| sensors.inertial.gyro = Vec3::ZERO).expect("it is found");
    assert_eq!(fault, Fault::Inertial);
}

#[test]
fn a_silent_foot_is_found_but_a_lifted_robot_is_none() {
    for side in Side::BOTH {
        let silent = found(2000, &STAND, |sensors| {
            let carries = FootPressure { front_left: 52.0, ..FootPressure::default() };
            (sensors.left_foot, sensors.right_foot) = (carries, carries);
            match side {
                Side::Left => sensors.left_foot = FootPressure::default(),
                Side::Right => sensors.right_foot = FootPressure::default(),
            }
        });
        assert_eq!(silent.map(|(fault, _)| fault), Some(Fault::Foot(side)));
    }
    let lifted = found(2000, &STAND, |sensors| {
        (sensors.left_foot, sensors.right_foot) = (FootPressure::default(), FootPressure::default());
    });
    assert_eq!(lifted, None);
}

#[test]
fn who_lies_down_is_not_blamed() {
    let mut targets = STAND;
    targets[Joint::RKneePitch] += 0.9;
    assert_eq!(found(2000, &targets, |sensors| sensors.inertial.pitch = 1.5), None);
}

#[test]
fn a_fault_stays_and_says_what_it_is() {
    let mut health = Health::new();
    for cycle in 0..300 {
        let sensors = Sensors { inertial: standing(0).inertial, ..standing(cycle) };
        health.step(&sensors, &STAND, &Stiffness::Walk.joints());
    }
    for cycle in 0..300 {
        health.step(&standing(cycle), &STAND, &Stiffness::Walk.joints());
    }
    assert_eq!(health.fault(), Some(Fault::Inertial));
    assert_eq!(Fault::Stuck(Joint::LHipRoll).to_string(), "LHipRoll does not follow its target");
}
