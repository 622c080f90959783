//! Cost of active, shared and changing components.

use bica::Tree;
use criterion::Criterion;

use crate::ticks::ticks;
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::shared::Diamond;
use bica_benches::trees::switch::{Root, Switch};

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("active");
    group.bench_function("ten of ten", |bencher| ticks(bencher, &mut TenOfTen::new()));
    group.bench_function("ten of a hundred", |bencher| ticks(bencher, &mut TenOfHundred::new()));
    group.bench_function("four, one shared by two", |bencher| ticks(bencher, &mut Diamond::new()));
    group.bench_function("a switch in every cycle", |bencher| ticks(bencher, &mut Switch::new()));
    let mut still = Switch::new();
    still.get_mut::<Root>().changes = false;
    group.bench_function("no switch", |bencher| ticks(bencher, &mut still));
    group.finish();
}
