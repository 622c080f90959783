//! One run of each component while the others are latent.

use std::time::{Duration, Instant as Clock};

use bica::{ComponentId, Tree};
use bica_player::Forward;
use bica_sim::setup::Frame;
use criterion::{BenchmarkId, Criterion};

use bica_benches::isolated::IsolatedComponent;

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("component");
    for (index, node) in Forward::GRAPH.nodes.iter().enumerate() {
        for frame in [Frame::Small, Frame::Medium, Frame::Large] {
            let (width, height) = frame.size();
            let mut alone = IsolatedComponent::new(ComponentId::new(index), frame);
            if alone.needs_image() {
                let id = BenchmarkId::new(node.name, format!("{width}x{height}"));
                group.bench_function(id, |bencher| bencher.iter_custom(|runs| time(&mut alone, runs)));
            } else if frame == Frame::Medium {
                group.bench_function(node.name, |bencher| bencher.iter(|| alone.run()));
            }
        }
    }
    group.finish();
}

/// Measures `runs` runs, each with a new image; loading the image is not measured.
fn time(alone: &mut IsolatedComponent, runs: u64) -> Duration {
    let mut sum = Duration::ZERO;
    for _ in 0..runs {
        alone.load_image();
        let began = Clock::now();
        alone.run();
        sum += began.elapsed();
    }
    sum
}
