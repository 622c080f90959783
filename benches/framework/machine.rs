//! One step of a state machine with five states, compared with the same machine as a `match`.

use std::hint::black_box;

use bica::{Instant, Tree};
use criterion::Criterion;

use bica_benches::trees::machine::{ByHand, Machine, Ring};

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("machine of five states");

    let mut tree = Machine::new();
    let (mut now, mut input) = (0, 0_u32);
    group.bench_function("component", |bencher| {
        bencher.iter(|| {
            now += 1000;
            input = input.wrapping_add(1);
            let tree = black_box(&mut tree);
            tree.get_mut::<Ring>().input = input;
            tree.tick(Instant::from_micros(now));
        });
    });

    let mut machine = ByHand::new();
    let (mut now, mut input) = (0, 0_u32);
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            now += 1000;
            input = input.wrapping_add(1);
            let machine = black_box(&mut machine);
            machine.input = input;
            machine.step(now);
        });
    });
    group.finish();
}
