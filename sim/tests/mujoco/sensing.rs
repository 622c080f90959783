//! Measurements against known states.

use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Command, FootPressure};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::mujoco::{Fault, Physics};
use glam::Vec3;

use crate::support::{alone, blind, stand};

#[test]
fn standing_robot_measures_its_weight_and_gravity() {
    let mut world = alone(1, &blind());
    stand(&mut world, 200);
    let (mut weight, mut force, mut gyro) = (0.0, Vec3::ZERO, Vec3::ZERO);
    for _ in 0..100 {
        stand(&mut world, 1);
        let sensors = world.sensors();
        weight += (sensors.left_foot.total() + sensors.right_foot.total()) / 100.0;
        force += sensors.inertial.acceleration / 100.0;
        gyro += sensors.inertial.gyro / 100.0;
    }
    assert!((weight - 9.81 * NAO.total_mass()).abs() < 0.5, "{weight} N");
    assert!((force.length() - 9.81).abs() < 0.05, "{force}");
    assert!(gyro.length() < 0.01, "{gyro}");
    let sensors = world.sensors();
    let (roll, pitch) = (sensors.inertial.roll, sensors.inertial.pitch);
    let expected = 9.81 * Vec3::new(-pitch.sin(), roll.sin() * pitch.cos(), roll.cos() * pitch.cos());
    assert!((force - expected).length() < 0.2, "{force} {expected}");
}

#[test]
fn leaning_torso_changes_pitch_and_gravity() {
    let mut targets = NAO.stand;
    for ankle in [Joint::LAnklePitch, Joint::RAnklePitch] {
        targets[ankle] -= 0.08;
    }
    let mut world = alone(1, &blind());
    for _ in 0..200 {
        world.act(&Command::new(targets, 1.0));
    }
    let inertial = world.sensors().inertial;
    assert!((0.05..0.13).contains(&inertial.pitch), "{inertial:?}");
    assert!((inertial.acceleration.x + 9.81 * inertial.pitch.sin()).abs() < 0.3, "{inertial:?}");
}

#[test]
fn pressure_follows_the_centre_of_mass() {
    let pressed = |turns: &[(Joint, f32)]| {
        let mut targets = NAO.stand;
        for (joint, turn) in turns {
            targets[*joint] += turn;
        }
        let mut world = alone(1, &blind());
        for _ in 0..200 {
            world.act(&Command::new(targets, 1.0));
        }
        (world.sensors().left_foot, world.sensors().right_foot)
    };
    for turn in [0.12_f32, -0.12] {
        // Both legs turn to the left: the torso is above the right foot.
        let (hips, ankles) = ([Joint::LHipRoll, Joint::RHipRoll], [Joint::LAnkleRoll, Joint::RAnkleRoll]);
        let (left, right) = pressed(&[(hips[0], turn), (hips[1], turn), (ankles[0], -turn), (ankles[1], -turn)]);
        assert!((right.total() - left.total()) * turn.signum() > 5.0, "{turn}: {left:?} {right:?}");
        let outwards = |foot: FootPressure| foot.front_right + foot.rear_right - foot.front_left - foot.rear_left;
        assert!((outwards(left) + outwards(right)) * turn.signum() > 5.0, "{turn}: {left:?} {right:?}");
        // Toes down: the robot leans back.
        let (left, right) = pressed(&[(Joint::LAnklePitch, turn / 2.0), (Joint::RAnklePitch, turn / 2.0)]);
        let backwards = |foot: FootPressure| foot.rear_left + foot.rear_right - foot.front_left - foot.front_right;
        assert!((backwards(left) + backwards(right)) * turn.signum() > 5.0, "{turn}: {left:?} {right:?}");
    }
}

#[test]
fn measured_joint_has_dead_time_and_delay() {
    for (dead_time, sensor_delay, cycles) in [(0.0, 0.0, 1), (0.03, 0.006, 4), (0.04, 0.03, 8)] {
        let mut world = alone(1, &Physics { dead_time, sensor_delay, ..blind() });
        stand(&mut world, 50);
        let before = world.sensors().angles[Joint::HeadYaw];
        let mut targets = NAO.stand;
        targets[Joint::HeadYaw] = 1.0;
        let moved = (1..20).find(|_| {
            world.act(&Command::new(targets, 1.0));
            (world.sensors().angles[Joint::HeadYaw] - before).abs() > 0.001
        });
        assert_eq!(moved, Some(cycles), "{dead_time} {sensor_delay}");
    }
}

#[test]
fn loaded_motors_draw_current_and_heat_up() {
    let mut world = alone(1, &blind());
    stand(&mut world, 2000);
    let sensors = world.sensors();
    let current = |joint| sensors.currents[joint];
    assert!((0.1..0.7).contains(&current(Joint::LKneePitch)), "{}", current(Joint::LKneePitch));
    assert!(current(Joint::HeadYaw) < 0.01);
    let temperatures = sensors.temperatures;
    assert!((25.0..30.0).contains(&temperatures[Joint::LKneePitch]), "{temperatures:?}");
    assert!((25.0..25.5).contains(&temperatures[Joint::HeadYaw]), "{temperatures:?}");
    world.set_motor_temperature(Joint::HeadYaw, 60.5);
    stand(&mut world, 1);
    assert!((world.sensors().temperatures[Joint::HeadYaw] - 60.0).abs() < 1e-3);
}

#[test]
fn failed_sensors_read_zero_and_failed_motors_stop() {
    let mut world = alone(1, &blind());
    stand(&mut world, 50);
    for fault in [Fault::Gyroscope, Fault::SoleSensors(Side::Left), Fault::Motor(Joint::HeadYaw)] {
        world.inject_fault(fault);
    }
    let mut targets = NAO.stand;
    (targets[Joint::HeadYaw], targets[Joint::HeadPitch]) = (1.0, 0.3);
    for _ in 0..100 {
        world.act(&Command::new(targets, 1.0));
    }
    let sensors = world.sensors();
    assert_eq!(sensors.inertial.gyro, Vec3::ZERO);
    assert_eq!(sensors.left_foot, FootPressure::default());
    let force = sensors.right_foot.total();
    assert!((10.0..9.81 * NAO.total_mass()).contains(&force), "{force} N");
    assert!(sensors.angles[Joint::HeadYaw].abs() < 0.1 && (sensors.angles[Joint::HeadPitch] - 0.3).abs() < 0.1);
}
