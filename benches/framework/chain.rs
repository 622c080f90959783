//! Chains of components, compared with the same work as plain functions on plain values.

use std::hint::black_box;

use bica::Tree;
use criterion::{Criterion, Throughput};

use crate::ticks::ticks;
use bica_benches::trees::chain::{Hundred, Rarely, Ten};
use bica_benches::trees::wide::WideHundred;

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("chain");
    group.throughput(Throughput::Elements(10));
    group.bench_function("ten, all due", |bencher| ticks(bencher, &mut Ten::new()));
    // Time advances by 1 µs in each cycle, so a component that runs every 1000 s is not due.
    let mut tree = Rarely::new();
    let mut now = 0;
    group.bench_function("ten, none due", |bencher| {
        bencher.iter(|| {
            now = (now + 1) % 1_000_000;
            black_box(&mut tree).tick(bica::Instant::from_micros(now));
        });
    });
    let mut values = [1; 10];
    group.bench_function("ten, by hand", |bencher| bencher.iter(|| by_hand(black_box(&mut values))));

    group.throughput(Throughput::Elements(100));
    group.bench_function("a hundred, all due", |bencher| ticks(bencher, &mut Hundred::new()));
    group.bench_function("a hundred in ten chains, all due", |bencher| ticks(bencher, &mut WideHundred::new()));
    group.finish();
}

#[inline(never)]
fn by_hand(values: &mut [u64; 10]) {
    for index in (0..10).rev() {
        let next = values[(index + 1).min(9)];
        values[index] = next.wrapping_mul(31).wrapping_add(1);
    }
}
