use std::thread;

use bica_motion::joints::{JOINTS, Joints};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{CameraId, Command};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

/// Runs a game with large motions. Returns all image bytes, all measurements and the final ground truth.
fn game(seed: u64, read_every: u32) -> (Vec<u8>, Vec<u32>, String) {
    let mut world = KinematicWorld::new(NAO, &Setup { seed, robots: 2, ..Setup::default() }).expect("a valid setup");
    let mut images = Vec::new();
    let mut words = Vec::new();
    for cycle in 0..400_u32 {
        if cycle % read_every == 0 {
            let sensors = world.sensors();
            images.extend(sensors.image.iter().flat_map(|image| image.yuyv));
            words.extend(sensors.angles.0.map(f32::to_bits));
            words.extend(sensors.inertial.gyro.to_array().map(f32::to_bits));
            words.push(sensors.left_foot.total().to_bits());
        }
        let wave = |i: usize| 0.2 * libm::sinf(cycle as f32 * 0.07 * (1.0 + i as f32 / JOINTS as f32));
        let targets = Joints(core::array::from_fn(|i| NAO.stand.0[i] + wave(i)));
        let camera = if cycle % 100 < 50 { CameraId::Top } else { CameraId::Bottom };
        world.act(&Command { camera, ..Command::new(targets, 1.0) });
    }
    (images, words, format!("{:?}", world.referee()))
}

#[test]
fn equal_seeds_give_equal_games_in_every_thread() {
    let first = game(11, 1);
    assert_eq!(first.0.len(), 120 * 320 * 240 * 2);
    let threads: Vec<_> = (0..2).map(|_| thread::spawn(|| game(11, 1))).collect();
    for thread in threads {
        assert!(thread.join().expect("a game without panic") == first);
    }
}

#[test]
fn different_seeds_give_different_games() {
    assert!(game(11, 1) != game(12, 1));
}

#[test]
fn reading_sensors_does_not_change_world() {
    let (_, words, truth) = game(11, 1);
    let (_, fewer_words, same_truth) = game(11, 10);
    assert_eq!(truth, same_truth);
    let per_read = words.len() / 400;
    let every_tenth: Vec<u32> = words.chunks(per_read).step_by(10).flatten().copied().collect();
    assert_eq!(every_tenth, fewer_words);
}

#[test]
fn repeated_reads_in_cycle_return_equal_measurements() {
    let mut world = KinematicWorld::new(NAO, &Setup::default()).expect("a valid setup");
    let mut images = 0;
    for _ in 0..10 {
        let first = world.sensors();
        let (inertial, image) = (first.inertial, first.image.map(|image| image.yuyv.to_vec()));
        images += u32::from(image.is_some());
        let second = world.sensors();
        assert_eq!(second.inertial, inertial);
        assert_eq!(second.image.map(|image| image.yuyv.to_vec()), image);
        world.act(&Command::new(NAO.stand, 1.0));
    }
    assert_eq!(images, 3);
}
