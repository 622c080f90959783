//! The whole loop from sensing to acting without the world, on recorded sensor values of a game and on real frames.

use std::hint::black_box;

use bica::Instant;
use bica::runner::Runner;
use bica_motion::robot::{CameraId, Sensors};
use bica_sim::setup::Frame;
use criterion::{BenchmarkId, Criterion, Throughput};

use bica_benches::frames::recorded;
use bica_benches::recording::{CYCLES, OwnedImage, Recording, WARM};
use bica_player::Forward;

pub(crate) fn bench(criterion: &mut Criterion) {
    let real = recorded::folder();
    let mut group = criterion.benchmark_group("whole loop");
    for frame in [Frame::Small, Frame::Medium, Frame::Large] {
        let (width, height) = frame.size();
        let size = format!("{width}x{height}");
        let (recording, robot) = Recording::of_game::<Forward>(frame, WARM, CYCLES);
        let mut runner = Runner::new(robot, ());
        let mut cycle = 1000;
        let mut think = |sensors: &Sensors<'_>| {
            let now = Instant::from_millis(10 * cycle);
            runner.sense(now, sensors).expect("the image fits");
            cycle += 1;
            black_box(runner.think(now))
        };
        group.throughput(Throughput::Elements(CYCLES as u64));
        group.bench_function(BenchmarkId::new("a game", &size), |bencher| {
            bencher.iter(|| recording.sensors().for_each(|sensors| _ = think(&sensors)));
        });
        let Some(folder) = real else { continue };
        for frame_set in recorded::frame_sets(folder, (width as u16, height as u16)) {
            let images: Vec<_> = frame_set.samples.iter().map(image).collect();
            let still = Sensors { image: None, ..recording.sensors().next().expect("a cycle") };
            group.throughput(Throughput::Elements(images.len() as u64));
            group.bench_function(
                BenchmarkId::new(format!("{}, each cycle an image", frame_set.name), &size),
                |bencher| {
                    bencher.iter(|| {
                        for image in &images {
                            think(&Sensors { image: Some(image.image()), ..still });
                        }
                    });
                },
            );
        }
    }
    group.finish();
}

/// Real frame, presented as an image of the robot's upper camera.
fn image(sample: &bica_benches::frames::Sample) -> OwnedImage {
    OwnedImage { camera: CameraId::Top, width: sample.width, height: sample.height, yuyv: sample.yuyv.clone() }
}
