//! A chain of ten: each component requires the next and does `v = v * 31 + 1`.

use std::hint::black_box;

use bica::prelude::*;
use criterion::{Criterion, Throughput};

macro_rules! chain {
    ($tree:ident, $rate:tt: $($name:ident <- $next:ident),*; $last:ident) => {
        $(chain!(@component $rate $name, fn step(&mut self, next: &$next) { self.0 = next.0.wrapping_mul(31).wrapping_add(1); });)*
        chain!(@component $rate $last, fn step(&mut self) { self.0 = self.0.wrapping_mul(31).wrapping_add(1); });
        activation_tree! {
            /// A chain of ten.
            pub(crate) struct $tree {
                root: C0,
                cycle_hz: 1000,
                components: [$($name,)* $last],
            }
        }
    };
    (@component every $name:ident, $step:item) => {
        #[doc = "A link of the chain."]
        pub(crate) struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self { Self(1) }
            $step
        }
    };
    (@component rarely $name:ident, $step:item) => {
        #[doc = "A link of the chain."]
        pub(crate) struct $name(u64);

        #[component(hz = 0.001)]
        impl $name {
            const fn new() -> Self { Self(1) }
            $step
        }
    };
}

mod every {
    use bica::prelude::*;
    chain!(Every, every: C0 <- C1, C1 <- C2, C2 <- C3, C3 <- C4, C4 <- C5, C5 <- C6, C6 <- C7, C7 <- C8, C8 <- C9; C9);
}

mod rarely {
    use bica::prelude::*;
    chain!(Rarely, rarely: C0 <- C1, C1 <- C2, C2 <- C3, C3 <- C4, C4 <- C5, C5 <- C6, C6 <- C7, C7 <- C8, C8 <- C9; C9);
}

/// The same ten steps as plain functions on plain values.
#[inline(never)]
fn by_hand(values: &mut [u64; 10]) {
    for index in (0..10).rev() {
        let next = values[(index + 1).min(9)];
        values[index] = next.wrapping_mul(31).wrapping_add(1);
    }
}

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("chain of ten");
    group.throughput(Throughput::Elements(10));

    let mut tree = every::Every::new();
    let mut now = 0;
    group.bench_function("all due", |bencher| {
        bencher.iter(|| {
            now += 1000;
            black_box(&mut tree).tick(Instant::from_micros(now));
        });
    });

    let mut tree = rarely::Rarely::new();
    let mut now = 0;
    group.bench_function("none due", |bencher| {
        bencher.iter(|| {
            now = (now + 1) % 1_000_000;
            black_box(&mut tree).tick(Instant::from_micros(now));
        });
    });

    let mut values = [1; 10];
    group.bench_function("by hand", |bencher| bencher.iter(|| by_hand(black_box(&mut values))));
    group.finish();
}
