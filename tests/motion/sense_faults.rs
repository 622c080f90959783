//! Faults of camera and gyroscope.

use bica_motion::health::{Fault, Glimpse, Senses};
use bica_motion::joints::Joint;
use bica_motion::model::{Calibration, NAO};
use bica_motion::odometry::LegsTurn;
use bica_motion::robot::Inertial;
use glam::Vec3;

use super::health::standing;

/// Fault after some images of 16×12 pixels, whose luma is a function of the image number and the position.
fn seen(images: u16, luma: impl Fn(u16, usize) -> u8) -> Option<Fault> {
    let mut senses = Senses::new();
    for image in 0..images {
        let yuyv: Vec<u8> = (0..2 * 16 * 12).map(|at| if at % 2 == 0 { luma(image, at) } else { 128 }).collect();
        senses.see(Glimpse::of(&yuyv).expect("pixels"));
    }
    senses.fault()
}

#[test]
fn frozen_black_and_white_images_are_faults() {
    let noise = |image: u16, at: usize| 100 + ((at as u16 + 7 * image) % 5) as u8;
    assert_eq!(seen(300, noise), None);
    for (images, fault) in [(20, None), (40, Some(Fault::FrozenImage))] {
        assert_eq!(seen(images, |_, at| noise(0, at)), fault, "{images} images");
    }
    assert_eq!(seen(40, |image, at| noise(image / 20, at)), None, "two pictures");
    assert_eq!(seen(40, |image, at| noise(image, at) - 90), Some(Fault::DarkImage));
    assert_eq!(seen(40, |image, at| noise(image, at) + 140), Some(Fault::BrightImage));
    assert_eq!(seen(40, |_, _| 16), Some(Fault::DarkImage), "a black image without noise");
    assert_eq!(Glimpse::of(&[]), None);
}

#[test]
fn missing_images_are_a_fault_until_one_comes() {
    let mut senses = Senses::new();
    (0..300).for_each(|cycle| senses.step(&standing(cycle), &NAO.stand));
    assert_eq!(senses.fault(), Some(Fault::NoImages));
    senses.see(Glimpse { digest: 1, brightness: 100 });
    assert_eq!(senses.fault(), None);
}

#[test]
fn gyroscope_offset_at_rest_is_a_fault() {
    let fault_after = |cycles: u32, offset: Vec3, moving: bool| {
        let mut senses = Senses::new();
        for cycle in 0..cycles {
            let mut sensors = standing(cycle);
            sensors.inertial.gyro += offset;
            let mut targets = NAO.stand;
            targets[Joint::LKneePitch] += if moving { 0.1 * (cycle % 40) as f32 } else { 0.0 };
            senses.step(&sensors, &targets);
            senses.see(Glimpse { digest: cycle, brightness: 100 });
        }
        senses.fault()
    };
    let fault = |offset, moving| fault_after(400, offset, moving);
    assert_eq!(fault_after(90, 0.1 * Vec3::Z, false), Some(Fault::GyroOffset), "in a short stand");
    for axis in [Vec3::X, -Vec3::Y, Vec3::Z] {
        assert_eq!(fault(0.2 * axis, false), Some(Fault::GyroOffset), "{axis}");
        assert_eq!(fault(0.2 * axis, true), None, "it walks");
        assert_eq!(fault(0.02 * axis, false), None, "the drift of a cheap gyroscope is no fault");
    }
    assert!(Fault::GyroOffset.is_temporary() && Fault::FrozenImage.is_temporary());
}

const fn legs_turn(angle: f32) -> LegsTurn {
    LegsTurn { angle, max_difference: Calibration::EXACT.max_turn_difference }
}

#[test]
fn slip_of_soles_that_say_nothing_is_no_offset() {
    for (max_difference, is_offset) in [(f32::INFINITY, false), (0.1, true)] {
        let mut senses = Senses::new();
        let inertial = Inertial { gyro: 0.3 * Vec3::Z, ..standing(0).inertial };
        (0..1000).for_each(|_| senses.turn(&inertial, Some(LegsTurn { angle: 0.0, max_difference }), 0.01));
        senses.see(Glimpse { digest: 1, brightness: 100 });
        assert_eq!(senses.fault() == Some(Fault::GyroOffset), is_offset, "{max_difference} rad/s");
    }
}

#[test]
fn an_offset_is_found_in_a_walk_within_5_s() {
    // Time until a fault is found, for a turn rate of the legs, a relative additional turn of the torso (`slip`), and an offset.
    let seconds = |legs: f32, slip: f32, offset: f32| {
        let mut senses = Senses::new();
        let cycle = (0_u16..1000).find(|&cycle| {
            let sway = 0.3 * (f32::from(cycle) * 0.12).sin();
            let gyro = Vec3::Z * (legs * (1.0 + slip) + offset + sway);
            senses.turn(&Inertial { gyro, ..standing(0).inertial }, Some(legs_turn(0.01 * legs)), 0.01);
            senses.see(Glimpse { digest: cycle.into(), brightness: 100 });
            senses.fault() == Some(Fault::GyroOffset)
        });
        cycle.map(|cycle| 0.01 * f32::from(cycle))
    };
    for (legs, slip, offset) in [(0.0, 0.0, 0.1), (0.3, 0.0, -0.1), (0.15, 0.1, 0.2), (-0.15, 0.1, 0.2)] {
        for side in [1.0, -1.0] {
            let seconds = seconds(side * legs, slip, side * offset);
            assert!(seconds.is_some_and(|seconds| seconds < 5.0), "{legs} rad/s {offset}: {seconds:?} s");
        }
    }
    for (legs, slip) in [(0.0, 0.0), (0.8, 0.1), (-0.8, 0.45), (0.4, 0.6)] {
        assert_eq!(seconds(legs, slip, 0.02), None, "{legs} rad/s");
    }
}

/// Whether a gyroscope has an offset by its turn rate, rad/s, and the pitch, rad, in each cycle of a walk straight ahead.
fn drifts(rate: impl Fn(u16) -> f32, pitch: impl Fn(u16) -> f32) -> bool {
    let mut senses = Senses::new();
    (0..1000).any(|cycle| {
        let inertial = Inertial { gyro: rate(cycle) * Vec3::Z, pitch: pitch(cycle), ..standing(0).inertial };
        senses.turn(&inertial, Some(legs_turn(0.0)), 0.01);
        senses.see(Glimpse { digest: cycle.into(), brightness: 100 });
        senses.fault() == Some(Fault::GyroOffset)
    })
}

#[test]
fn windows_before_a_fall_do_not_count() {
    let falls = |every| move |cycle: u16| if cycle.is_multiple_of(every) { 1.0 } else { 0.0 };
    assert!(drifts(|_| 0.1, falls(250)) && !drifts(|_| 0.1, falls(140)));
}

#[test]
fn the_recoil_of_a_kick_is_no_offset() {
    let kicks = |cycle: u16| if cycle % 300 < 30 { 1.0 } else { 0.0 };
    assert!(!drifts(kicks, |_| 0.0));
}
