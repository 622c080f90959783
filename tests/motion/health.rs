//! Faults of the body.

use std::cell::Cell;

use bica_motion::health::{Fault, Health};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::{NAO, T1};
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use glam::Vec3;

/// Sensors of a standing robot in a cycle, with noise of the inertial unit.
pub(crate) fn standing(cycle: u32) -> Sensors<'static> {
    let foot = FootPressure { front_left: 26.0, ..FootPressure::default() };
    let noise = 1e-3 * (cycle % 7) as f32;
    Sensors {
        angles: NAO.stand,
        temperatures: Joints::all(40.0),
        currents: Joints::all(0.1),
        inertial: Inertial { gyro: Vec3::splat(noise), acceleration: Vec3::Z * 9.81, roll: 0.0, pitch: 0.0 },
        left_foot: foot,
        right_foot: foot,
        buttons: Buttons::default(),
        image: None,
    }
}

/// First fault in `cycles` with changed sensors, and the cycle in which it is reported.
fn found(cycles: u32, targets: &Joints, change: impl Fn(&mut Sensors<'_>)) -> Option<(Fault, u32)> {
    let mut health = Health::new(NAO);
    let stiffness = Stiffness::Walk.joints(NAO);
    (0..cycles).find_map(|cycle| {
        let mut sensors = standing(cycle);
        change(&mut sensors);
        health.step(&sensors, targets, &stiffness);
        health.fault().map(|fault| (fault, cycle))
    })
}

#[test]
fn a_standing_robot_with_valid_sensors_has_no_fault() {
    assert_eq!(found(2000, &NAO.stand, |_| ()), None);
}

#[test]
fn a_stuck_leg_joint_is_a_fault_within_a_second() {
    let mut targets = NAO.stand;
    targets[Joint::RKneePitch] += 0.9;
    let (fault, cycle) = found(2000, &targets, |_| ()).expect("a fault is reported");
    assert_eq!(fault, Fault::Stuck(Joint::RKneePitch));
    assert!((45..60).contains(&cycle), "{cycle}");
    targets[Joint::RKneePitch] = NAO.stand[Joint::RKneePitch] + 0.28;
    assert_eq!(found(2000, &targets, |_| ()), None, "a small deviation is no fault");
    for (joint, deviation) in [(Joint::RKneePitch, 0.7), (Joint::HeadYaw, 0.7), (Joint::HeadPitch, 0.35)] {
        let mut targets = NAO.stand;
        targets[joint] += deviation;
        assert_eq!(found(200, &targets, |_| ()).map(|found| found.0), Some(Fault::Stuck(joint)), "{deviation}");
    }
    let silent = |sensors: &mut Sensors<'_>| sensors.angles[Joint::LHipRoll] = f32::NAN;
    assert_eq!(found(200, &NAO.stand, silent).map(|found| found.0), Some(Fault::Stuck(Joint::LHipRoll)));
    let mut arms = NAO.stand;
    arms[Joint::LShoulderPitch] -= 1.0;
    assert_eq!(found(2000, &arms, |_| ()), None, "arms are compliant");
}

/// Fault of a robot of whose joint the target and the angle differ from the stand by functions of time, s; and its time. It lies for a
/// second from a time on, s.
fn swung(joint: Joint, lies: f32, target: impl Fn(f32) -> f32, angle: impl Fn(f32) -> f32) -> Option<(Fault, f32)> {
    let (mut health, stiffness) = (Health::new(NAO), Stiffness::Walk.joints(NAO));
    (0..1000_u16).find_map(|cycle| {
        let (mut sensors, mut targets, t) = (standing(cycle.into()), NAO.stand, 0.01 * f32::from(cycle));
        targets[joint] += target(t);
        sensors.angles[joint] += angle(t);
        sensors.inertial.pitch = if (lies..lies + 1.0).contains(&t) { 1.5 } else { 0.0 };
        health.step(&sensors, &targets, &stiffness);
        health.fault().map(|fault| (fault, t))
    })
}

#[test]
fn a_joint_at_rest_while_its_target_swings_is_stuck() {
    let swing = |amplitude: f32, delay: f32| move |t: f32| amplitude * (12.0 * (t - delay)).sin();
    for joint in [Joint::LKneePitch, Joint::RHipRoll, Joint::HeadYaw] {
        let named = |lies, angle: &dyn Fn(f32) -> f32| match swung(joint, lies, swing(0.05, 0.0), angle) {
            Some((fault, t)) if fault == Fault::Stuck(joint) => t,
            other => panic!("{joint:?}: {other:?}"),
        };
        let t = named(10.0, &swing(0.003, 0.04));
        assert!((0.9..1.3).contains(&t), "{t} s");
        let (lay, moved) = (named(0.8, &|_| 0.0), named(0.8, &|t| if (1.2..1.5).contains(&t) { 0.03 } else { 0.0 }));
        assert!(lay < 2.2 && moved > 2.5, "a fall delays it by {lay} s, one in which the joint moves by {moved} s");
        assert_eq!(swung(joint, 10.0, swing(0.2, 0.0), swing(0.1, 0.1)), None, "it follows, late and by half");
        assert_eq!(swung(joint, 10.0, swing(0.015, 0.0), |_| 0.0), None, "it hardly has to move");
    }
    let once = |t: f32| (0.5 * t).min(0.28);
    assert_eq!(swung(Joint::LKneePitch, 10.0, once, |_| 0.0), None, "the ground may block one motion");
}

#[test]
fn a_joint_that_moves_far_from_its_target_is_stuck() {
    let behind = |by: f32| swung(Joint::RKneePitch, 10.0, move |t| by + 0.1 * t, |t| 0.1 * t);
    let (fault, t) = behind(0.7).expect("a fault is reported");
    assert!(fault == Fault::Stuck(Joint::RKneePitch) && (0.9..1.1).contains(&t), "{fault} {t}");
    assert_eq!(behind(0.6), None, "the lag of the fastest kick");
}

#[test]
fn rests_of_a_joint_add_up_until_it_moves() {
    let target = |t: f32| if (0.4..1.4).contains(&t) { 0.0 } else { 0.5 };
    let named = |angle: &dyn Fn(f32) -> f32| swung(Joint::RHipRoll, 10.0, target, angle).expect("a fault").1;
    let (rests, moved) = (named(&|_| 0.0), named(&|t| if t < 1.0 { 0.0 } else { 0.02 }));
    assert!((1.45..1.55).contains(&rests) && (1.85..1.95).contains(&moved), "{rests} s, {moved} s");
}

#[test]
fn a_head_at_rest_beside_its_target_is_stuck() {
    let at = |target: f32, speed: f32| swung(Joint::HeadYaw, 10.0, move |t| target + speed * t, move |t| speed * t);
    let (fault, t) = at(0.1, 0.0).expect("a fault is reported");
    assert!(fault == Fault::Stuck(Joint::HeadYaw) && (0.9..1.1).contains(&t), "{fault} {t}");
    assert_eq!(at(0.05, 0.0), None, "its weight");
    assert_eq!(at(0.16, 4.0), None, "the lag of the fastest motion");
    assert_eq!(swung(Joint::LKneePitch, 10.0, |_| 0.28, |_| 0.0), None, "a leg carries the body");
}

#[test]
fn frozen_inertial_reading_is_a_fault() {
    let (fault, cycle) =
        found(2000, &NAO.stand, |sensors| sensors.inertial.gyro = Vec3::ZERO).expect("a fault is reported");
    assert_eq!(fault, Fault::Inertial);
    assert!((99..=101).contains(&cycle), "{cycle}");
    for odd in [f32::NAN, f32::INFINITY, 1e20] {
        let found = found(2000, &NAO.stand, |sensors| sensors.inertial.gyro.x = odd);
        assert_eq!(found.map(|found| found.0), Some(Fault::Inertial), "{odd} rad/s");
    }
}

#[test]
fn one_silent_foot_is_a_fault_and_two_are_not() {
    for side in Side::BOTH {
        let silent = found(2000, &NAO.stand, |sensors| {
            let loaded = FootPressure { front_left: 52.0, ..FootPressure::default() };
            (sensors.left_foot, sensors.right_foot) = (loaded, loaded);
            match side {
                Side::Left => sensors.left_foot = FootPressure::default(),
                Side::Right => sensors.right_foot = FootPressure::default(),
            }
        });
        let (fault, cycle) = silent.expect("a fault is reported");
        assert_eq!(fault, Fault::Foot(side));
        assert!((399..=401).contains(&cycle), "{cycle}");
    }
    let lifted = found(2000, &NAO.stand, |sensors| {
        (sensors.left_foot, sensors.right_foot) = (FootPressure::default(), FootPressure::default());
    });
    assert_eq!(lifted, None);
}

#[test]
fn estimated_force_is_no_fault_of_a_foot() {
    let mut health = Health::new(T1);
    for cycle in 0..2000 {
        let right_foot = FootPressure { front_left: 300.0, ..FootPressure::default() };
        let sensors = Sensors { angles: T1.stand, left_foot: FootPressure::default(), right_foot, ..standing(cycle) };
        health.step(&sensors, &T1.stand, &Stiffness::Walk.joints(T1));
    }
    assert_eq!(health.fault(), None);
}

#[test]
fn joint_of_a_t1_may_rest_beside_its_target() {
    for (model, fault) in [(NAO, Some(Fault::Stuck(Joint::LHipRoll))), (T1, None)] {
        let (mut health, mut targets) = (Health::new(model), model.stand);
        targets[Joint::LHipRoll] += 0.4;
        for cycle in 0..300 {
            let sensors = Sensors { angles: model.stand, ..standing(cycle) };
            health.step(&sensors, &targets, &Stiffness::Walk.joints(model));
        }
        assert_eq!(health.fault(), fault, "{}", model.id);
    }
}

#[test]
fn unloaded_foot_is_no_fault() {
    let on_right_foot = |sensors: &mut Sensors<'_>| {
        sensors.left_foot = FootPressure::default();
        sensors.right_foot = FootPressure { front_left: 52.0, ..FootPressure::default() };
    };
    let mut lifted = NAO.stand;
    lifted[Joint::LHipPitch] -= 0.1;
    lifted[Joint::LKneePitch] += 0.2;
    lifted[Joint::LAnklePitch] -= 0.1;
    let mut shifted = NAO.stand;
    for (hip, ankle) in [(Joint::LHipRoll, Joint::LAnkleRoll), (Joint::RHipRoll, Joint::RAnkleRoll)] {
        shifted[hip] += 0.4;
        shifted[ankle] -= 0.4;
    }
    for posture in [lifted, shifted] {
        let upright = |sensors: &mut Sensors<'_>| {
            on_right_foot(sensors);
            sensors.angles = posture;
        };
        assert_eq!(found(2000, &posture, upright), None);
    }
    assert_eq!(found(2000, &NAO.stand, on_right_foot).map(|found| found.0), Some(Fault::Foot(Side::Left)));
}

#[test]
fn a_joint_at_rest_in_a_get_up_is_stuck_after_1_s() {
    let knee = Joint::RKneePitch;
    let lying = |deviation: f32, angle: &dyn Fn(u32) -> f32| {
        let (mut targets, cycle) = (NAO.stand, Cell::new(0));
        targets[knee] += deviation;
        found(500, &targets, |sensors| {
            sensors.angles[knee] = angle(cycle.replace(cycle.get() + 1));
            sensors.inertial.pitch = 1.5;
        })
    };
    let stand = NAO.stand[knee];
    let (fault, cycle) = lying(0.9, &|_| stand).expect("a fault is reported");
    assert!(fault == Fault::Stuck(knee) && (95..105).contains(&cycle), "{fault} {cycle}");
    assert_eq!(lying(0.18, &|_| stand), None, "its load");
    assert_eq!(
        lying(0.9, &|cycle| stand + 0.02 * (cycle / 90) as f32),
        None,
        "the ground blocks it, and it moves again"
    );
    assert_eq!(lying(0.0, &|_| NAO.limits[knee].max), None, "the body presses it to its end");
}

#[test]
fn a_sensor_fault_is_permanent() {
    let mut health = Health::new(NAO);
    for cycle in 0..300 {
        let sensors = Sensors { inertial: standing(0).inertial, ..standing(cycle) };
        health.step(&sensors, &NAO.stand, &Stiffness::Walk.joints(NAO));
    }
    for cycle in 0..300 {
        health.step(&standing(cycle), &NAO.stand, &Stiffness::Walk.joints(NAO));
    }
    assert_eq!(health.fault(), Some(Fault::Inertial));
    assert_eq!(Fault::Stuck(Joint::LHipRoll).to_string(), "LHipRoll does not follow its target");
}

/// First fault in `cycles` with the left knee's motor at a temperature (°C) and a current (A).
fn overloaded(cycles: u32, temperature: f32, current: f32) -> Option<(Fault, u32)> {
    found(cycles, &NAO.stand, |sensors| {
        sensors.temperatures[Joint::LKneePitch] = temperature;
        sensors.currents[Joint::LKneePitch] = current;
    })
}

#[test]
fn a_motor_at_75_degrees_is_a_fault_after_one_second() {
    let (fault, cycle) = overloaded(2000, 75.0, 0.5).expect("a fault is reported");
    assert_eq!(fault, Fault::Hot(Joint::LKneePitch));
    assert!((90..110).contains(&cycle), "{cycle}");
    assert_eq!(overloaded(2000, 74.0, 0.5), None);
    assert_eq!(fault.to_string(), "LKneePitch is too hot");
}

#[test]
fn thermal_faults_end_when_all_motors_have_cooled() {
    let hot = |temperature| move |sensors: &mut Sensors<'_>| sensors.temperatures[Joint::LKneePitch] = temperature;
    let pushing = |sensors: &mut Sensors<'_>| sensors.currents[Joint::LKneePitch] = 2.0;
    let lying = |sensors: &mut Sensors<'_>| sensors.inertial.pitch = 1.2;
    let mut health = Health::new(NAO);
    let mut live = |change: &dyn Fn(&mut Sensors<'_>), cycles: u32| {
        for cycle in 0..cycles {
            let mut sensors = standing(cycle);
            change(&mut sensors);
            health.step(&sensors, &NAO.stand, &Stiffness::Walk.joints(NAO));
        }
        health.fault()
    };
    let (too_hot, overloaded) = (Some(Fault::Hot(Joint::LKneePitch)), Some(Fault::Overloaded(Joint::LKneePitch)));
    assert_eq!(live(&hot(75.0), 200), too_hot);
    assert_eq!(live(&hot(70.0), 2000), too_hot, "still above the limit");
    assert_eq!(live(&hot(69.0), 1), None);
    assert_eq!(live(&pushing, 900), overloaded);
    assert_eq!(live(&|_| (), 900), overloaded, "still above the limit");
    assert_eq!(live(&|_| (), 1500), None);
    assert_eq!(live(&pushing, 900), overloaded);
    assert_eq!(live(&lying, 1), None, "a lying robot has no load");
    assert!(Fault::Hot(Joint::LKneePitch).is_temporary() && Fault::Overloaded(Joint::LKneePitch).is_temporary());
    assert!(!Fault::Inertial.is_temporary() && !Fault::Stuck(Joint::LKneePitch).is_temporary());
}

#[test]
fn interrupted_high_temperatures_are_no_fault() {
    let mut health = Health::new(NAO);
    for cycle in 0..1000 {
        let mut sensors = standing(cycle);
        sensors.temperatures[Joint::LKneePitch] = if cycle % 50 == 0 { 40.0 } else { 90.0 };
        health.step(&sensors, &NAO.stand, &Stiffness::Walk.joints(NAO));
    }
    assert_eq!(health.fault(), None);
}

#[test]
fn only_a_long_overload_is_a_fault() {
    let (fault, cycle) = overloaded(2000, 40.0, 2.0).expect("a fault is reported");
    assert_eq!(fault, Fault::Overloaded(Joint::LKneePitch));
    assert!((500..900).contains(&cycle), "{cycle}");
    assert_eq!(overloaded(300, 40.0, 2.0), None);
    assert_eq!(overloaded(20_000, 40.0, 1.2), None, "the current of a walk");
    let getting_up = found(2000, &NAO.stand, |sensors| {
        (sensors.inertial.pitch, sensors.currents[Joint::LKneePitch]) = (1.2, 2.0);
    });
    assert_eq!(getting_up, None);
}

#[test]
fn unknown_temperatures_and_currents_are_no_fault() {
    for odd in [f32::NAN, f32::NEG_INFINITY, f32::MIN_POSITIVE, -0.0] {
        let unknown = found(2000, &NAO.stand, |sensors| {
            (sensors.temperatures, sensors.currents) = (Joints::all(odd), Joints::all(f32::NAN));
        });
        assert_eq!(unknown, None);
    }
    let mut health = Health::new(NAO);
    let silent = Sensors { temperatures: Joints::all(f32::NAN), currents: Joints::all(f32::NAN), ..standing(0) };
    let stiffness = Stiffness::Walk.joints(NAO);
    health.step(&silent, &NAO.stand, &stiffness);
    assert_eq!(health.derated(&stiffness), stiffness);
}

#[test]
fn stiffness_falls_with_temperature_and_load() {
    let left = |temperature: f32, current: f32, cycles: u32| {
        let mut health = Health::new(NAO);
        for cycle in 0..cycles {
            let mut sensors = standing(cycle);
            sensors.temperatures[Joint::LKneePitch] = temperature;
            sensors.currents[Joint::LKneePitch] = current;
            health.step(&sensors, &NAO.stand, &Stiffness::Walk.joints(NAO));
        }
        let eased = health.derated(&Joints::all(1.0));
        assert!(eased[Joint::RKneePitch] > 0.999);
        eased[Joint::LKneePitch]
    };
    assert!(left(20.0, 0.1, 1) > 0.999 && left(70.0, 0.1, 1) > 0.999);
    assert!((left(72.5, 0.1, 1) - 0.85).abs() < 1e-6);
    assert!((left(75.0, 0.1, 1) - 0.7).abs() < 1e-6 && (left(99.0, 0.1, 1) - 0.7).abs() < 1e-6);
    let pushing = [100, 550, 700].map(|cycles| left(40.0, 2.0, cycles));
    assert!(pushing[0] > 0.999 && pushing[1] < 1.0 && pushing[2] < pushing[1], "{pushing:?}");
}
