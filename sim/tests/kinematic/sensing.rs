use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use glam::Vec2;

use crate::support::{TOGETHER, alone, glide, swayed};
use bica_motion::side::Side;

#[test]
fn selected_camera_delivers_thirty_images_second() {
    for frame in [Frame::Small, Frame::Medium, Frame::Large] {
        let mut world = KinematicWorld::new(NAO, &Setup { frame, ..Setup::default() }).expect("a valid setup");
        let (mut images, mut camera) = (0, CameraId::Top);
        for cycle in 0..200 {
            if let Some(image) = world.sensors().image {
                images += 1;
                assert_eq!(image.camera, camera);
                assert_eq!((usize::from(image.width), usize::from(image.height)), frame.size());
                assert_eq!(image.yuyv.len(), 2 * frame.size().0 * frame.size().1);
            }
            camera = if cycle < 100 { CameraId::Top } else { CameraId::Bottom };
            world.act(&Command { camera, ..Command::new(NAO.stand, 1.0) });
        }
        assert_eq!(images, 60);
    }
}

#[test]
fn standing_robot_measures_its_weight_and_gravity() {
    let mut world = alone(1, Pose2::new(-1.0, 0.5, 1.0), Vec2::ZERO);
    for _ in 0..100 {
        world.act(&Command::new(NAO.stand, 1.0));
        let sensors = world.sensors();
        let force = sensors.left_foot.total() + sensors.right_foot.total();
        assert!((force - NAO.total_mass() * 9.81).abs() < 4.0, "{force}");
        assert!(sensors.inertial.roll.abs() < 0.02 && sensors.inertial.pitch.abs() < 0.02);
        assert!((sensors.inertial.acceleration.z - 9.81).abs() < 0.2);
        assert!(sensors.inertial.gyro.length() < 0.02);
    }
    assert!(world.referee().robot().position.distance(Vec2::new(-1.0, 0.5)) < 1e-4);
}

#[test]
fn consecutive_images_differ_by_noise() {
    let mut world = alone(1, Pose2::ORIGIN, Vec2::new(1.0, 0.0));
    let mut images = Vec::new();
    for _ in 0..20 {
        images.extend(world.sensors().image.map(|image| image.yuyv.to_vec()));
        world.act(&Command::new(NAO.stand, 1.0));
    }
    assert_eq!(images.len(), 6);
    for pair in images.windows(2) {
        let differences = pair[0].iter().zip(&pair[1]).map(|(a, b)| f64::from(a.abs_diff(*b)));
        let mean = differences.sum::<f64>() / pair[0].len() as f64;
        assert!((0.5..6.0).contains(&mean), "{mean}");
    }
}

#[test]
fn pressure_moves_to_foot_under_hips() {
    let mut world = alone(1, Pose2::ORIGIN, Vec2::new(1.0, 1.0));
    glide(&mut world, TOGETHER, swayed(Side::Right), 60);
    glide(&mut world, swayed(Side::Right), swayed(Side::Right), 10);
    let sensors = world.sensors();
    let (left, right) = (sensors.left_foot.total(), sensors.right_foot.total());
    assert!(right > 5.0 * left && (left + right - NAO.total_mass() * 9.81).abs() < 4.0, "{left} {right}");
    let mut lifted = swayed(Side::Right);
    lifted[0].2 = 0.03;
    glide(&mut world, swayed(Side::Right), lifted, 30);
    glide(&mut world, lifted, lifted, 30);
    assert_eq!(world.sensors().left_foot.total(), 0.0);
    assert_eq!(world.referee().falls(), 0);
}
