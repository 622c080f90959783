//! Estimates of tilt and support for robots without these measurements.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::{K1, NAO, RobotModel, T1};
use bica_motion::robot::{FootPressure, Inertial, Sensors};
use bica_motion::senses::SenseEstimator;
use glam::{Quat, Vec3};

const CYCLE: f32 = 0.01;

fn sensors(angles: Joints, gyro: Vec3, acceleration: Vec3) -> Sensors<'static> {
    let inertial = Inertial { gyro, acceleration, roll: 0.5, pitch: 0.5 };
    let foot = FootPressure { front_left: 1.0, ..FootPressure::default() };
    Sensors { angles, inertial, left_foot: foot, right_foot: foot, ..Sensors::UNMEASURED }
}

#[test]
fn tilt_of_a_still_torso_is_measured() {
    let turn = Quat::from_rotation_y(0.2) * Quat::from_rotation_x(-0.1);
    let mut estimator = SenseEstimator::new(T1);
    let mut seen = sensors(T1.stand, Vec3::ZERO, turn.inverse() * Vec3::new(0.0, 0.0, 9.81));
    (0..1000).for_each(|_| estimator.complete(&mut seen, CYCLE));
    assert!(
        (seen.inertial.roll + 0.1).abs() < 0.005 && (seen.inertial.pitch - 0.2).abs() < 0.005,
        "{:?}",
        seen.inertial
    );
}

#[test]
fn fast_turn_is_found_from_the_gyroscope_alone() {
    let mut estimator = SenseEstimator::new(T1);
    // Twice gravity is an impact, of which nothing about the tilt follows.
    let mut seen = sensors(T1.stand, Vec3::new(0.0, 1.0, 0.0), Vec3::new(19.6, 0.0, 0.0));
    (0..50).for_each(|_| estimator.complete(&mut seen, CYCLE));
    assert!((seen.inertial.pitch - 0.5).abs() < 0.005 && seen.inertial.roll.abs() < 1e-4, "{:?}", seen.inertial);
}

fn forces(model: &'static RobotModel, bent: Option<Joint>) -> [f32; 2] {
    let mut angles = model.stand;
    if let Some(knee) = bent {
        angles[knee] += 0.3;
    }
    let mut seen = sensors(angles, Vec3::ZERO, Vec3::new(0.0, 0.0, 9.81));
    SenseEstimator::new(model).complete(&mut seen, CYCLE);
    [seen.left_foot.total(), seen.right_foot.total()]
}

#[test]
fn lower_sole_bears_the_weight() {
    let weight = 9.81 * K1.total_mass();
    for (bent, shares) in
        [(None, [0.5, 0.5]), (Some(Joint::LKneePitch), [0.0, 1.0]), (Some(Joint::RKneePitch), [1.0, 0.0])]
    {
        for (force, share) in forces(K1, bent).into_iter().zip(shares) {
            assert!((force - share * weight).abs() < 0.01 * weight, "{bent:?}: {force} N");
        }
    }
    assert!(
        forces(NAO, Some(Joint::LKneePitch)).iter().all(|share| (share - 1.0).abs() < 1e-6),
        "a NAO measures its forces"
    );
}
