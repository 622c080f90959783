//! The whole loop, from sensing to acting, without the world: on what was sensed in a game, and on real frames.

use std::hint::black_box;

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_motion::robot::{CameraId, Sensors};
use bica_sim::setup::Frame;
use criterion::{BenchmarkId, Criterion, Throughput};

use crate::recorded;
use crate::recording::{CYCLES, Picture, Recording, WARM};

pub(crate) fn bench(criterion: &mut Criterion) {
    let real = recorded::folder();
    let mut group = criterion.benchmark_group("whole loop");
    for frame in [Frame::Small, Frame::Medium, Frame::Large] {
        let (width, height) = frame.size();
        let size = format!("{width}x{height}");
        let (recording, mut robot) = Recording::of_game(frame, WARM, CYCLES);
        let mut cycle = 1000;
        let mut think = |sensors: &Sensors<'_>| {
            robot.sense(sensors).expect("the eye is large enough");
            robot.tick(Instant::from_millis(10 * cycle));
            cycle += 1;
            black_box(robot.act())
        };
        group.throughput(Throughput::Elements(CYCLES as u64));
        group.bench_function(BenchmarkId::new("a game", &size), |bencher| {
            bencher.iter(|| recording.sensors().for_each(|sensors| _ = think(&sensors)));
        });
        let Some(folder) = real else { continue };
        for album in recorded::albums(folder, (width as u16, height as u16)) {
            let pictures: Vec<_> = album.shots.iter().map(picture).collect();
            let still = Sensors { image: None, ..recording.sensors().next().expect("a cycle") };
            group.throughput(Throughput::Elements(pictures.len() as u64));
            group.bench_function(BenchmarkId::new(format!("{}, each cycle an image", album.name), &size), |bencher| {
                bencher.iter(|| {
                    for picture in &pictures {
                        think(&Sensors { image: Some(picture.image()), ..still });
                    }
                });
            });
        }
    }
    group.finish();
}

/// A real frame as if the robot's own upper camera had taken it.
fn picture(shot: &crate::shot::Shot) -> Picture {
    Picture { camera: CameraId::Top, width: shot.width, height: shot.height, yuyv: shot.yuyv.clone() }
}
