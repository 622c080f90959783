//! The framework: 100 cycles of each tree.

use std::hint::black_box;

use bica::prelude::*;
use gungraun::prelude::*;

use crate::slow::slow_down;
use bica_benches::trees::chain::{Hundred, Rarely, Ten};
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::machine::{ByHand, Machine, Ring};
use bica_benches::trees::one::One;
use bica_benches::trees::shared::Diamond;
use bica_benches::trees::switch::{Root, Switch};
use bica_benches::trees::tuned::{Constants, TunedOff, TunedOn};
use bica_benches::trees::wide::{WideHundred, WideTen};

const CYCLES: u64 = 100;

/// Ticks a new tree for 100 cycles, so that its components are active.
fn warm<T: Tree>(mut tree: T) -> T {
    ticks(&mut tree, 0, |_, _| {});
    tree
}

fn ticks<T: Tree>(tree: &mut T, from: u64, mut before: impl FnMut(&mut T, u64)) {
    for now in from..from + CYCLES {
        before(tree, now);
        black_box(&mut *tree).tick(Instant::from_millis(now));
        slow_down(T::COUNT);
    }
}

fn still() -> Switch {
    let mut tree = Switch::new();
    tree.get_mut::<Root>().changes = false;
    warm(tree)
}

/// One benchmark function for each tree, because gungraun does not accept generic functions.
macro_rules! trees {
    ($($name:ident: $kind:ty = $tree:expr),* $(,)?) => {
        $(
            #[library_benchmark]
            #[bench::cycles($tree)]
            fn $name(mut tree: $kind) -> $kind {
                ticks(&mut tree, CYCLES, |_, _| {});
                tree
            }
        )*
    };
}

trees! {
    one: One = warm(One::new()),
    chain_of_ten: Ten = warm(Ten::new()),
    chain_of_ten_none_due: Rarely = warm(Rarely::new()),
    chain_of_a_hundred: Hundred = warm(Hundred::new()),
    ten: WideTen = warm(WideTen::new()),
    a_hundred: WideHundred = warm(WideHundred::new()),
    ten_of_ten: TenOfTen = warm(TenOfTen::new()),
    ten_of_a_hundred: TenOfHundred = warm(TenOfHundred::new()),
    shared: Diamond = warm(Diamond::new()),
    switch: Switch = warm(Switch::new()),
    no_switch: Switch = still(),
    constants: Constants = warm(Constants::new()),
    tuned_off: TunedOff = warm(TunedOff::new()),
    tuned_on: TunedOn = warm(TunedOn::new()),
}

/// Robots in one process, each with a tree.
fn robots<T: Tree + Default>(count: usize) -> Vec<T> {
    (0..count).map(|_| warm(T::default())).collect()
}

/// Ticks all robots in each cycle.
fn all_tick<T: Tree>(robots: &mut [T]) {
    for now in CYCLES..2 * CYCLES {
        for tree in &mut *robots {
            black_box(tree).tick(Instant::from_millis(now));
        }
        slow_down(T::COUNT * robots.len());
    }
}

#[library_benchmark]
#[bench::cycles(robots(10))]
fn ten_robots_of_a_hundred(mut robots: Vec<WideHundred>) -> Vec<WideHundred> {
    all_tick(&mut robots);
    robots
}

#[library_benchmark]
#[bench::cycles(robots(100))]
fn a_hundred_robots_of_ten(mut robots: Vec<WideTen>) -> Vec<WideTen> {
    all_tick(&mut robots);
    robots
}

#[library_benchmark]
#[bench::cycles(warm(Machine::new()))]
fn machine(mut tree: Machine) -> Machine {
    ticks(&mut tree, CYCLES, |tree, now| tree.get_mut::<Ring>().input = now as u32);
    tree
}

#[library_benchmark]
#[bench::cycles(ByHand::new())]
fn machine_by_hand(mut machine: ByHand) -> ByHand {
    for now in CYCLES..2 * CYCLES {
        let machine = black_box(&mut machine);
        machine.input = now as u32;
        machine.step(1000 * now);
    }
    machine
}

library_benchmark_group!(
    name = trees,
    benchmarks = [
        one,
        chain_of_ten,
        chain_of_ten_none_due,
        chain_of_a_hundred,
        ten,
        a_hundred,
        ten_of_ten,
        ten_of_a_hundred,
        shared,
        switch,
        no_switch,
        constants,
        tuned_off,
        tuned_on,
        ten_robots_of_a_hundred,
        a_hundred_robots_of_ten,
        machine,
        machine_by_hand
    ]
);
