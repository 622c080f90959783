//! The framework: 100 cycles of each tree.

use std::hint::black_box;

use bica::prelude::*;
use bica_benches::trees::chain::{Hundred, Rarely, Ten};
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::machine::{ByHand, Machine, Ring};
use bica_benches::trees::one::One;
use bica_benches::trees::shared::Diamond;
use bica_benches::trees::switch::{Root, Switch};
use bica_benches::trees::tuned::{Constants, TunedOff, TunedOn};
use bica_benches::trees::wide::{WideHundred, WideTen};

use crate::case::Case;
use crate::slow::slow_down;

const CYCLES: u64 = 100;

/// Ticks a new tree for 100 cycles, so that its components are active.
fn warm<T: Tree>(mut tree: T) -> T {
    ticks(&mut tree, 0, |_, _| {});
    tree
}

fn ticks<T: Tree>(tree: &mut T, from: u64, before: impl Fn(&mut T, u64)) {
    for now in from..from + CYCLES {
        before(tree, now);
        black_box(&mut *tree).tick(Instant::from_millis(now));
        slow_down(T::COUNT);
    }
}

fn tree<T: Tree + Default + 'static>(name: &str) -> Case {
    changed::<T>(name, |_| {}, |_, _| {})
}

/// Benchmark of a tree that is changed before all cycles, and before each.
fn changed<T: Tree + Default + 'static>(name: &str, first: fn(&mut T), each: impl Fn(&mut T, u64) + 'static) -> Case {
    let prepare = move || {
        let mut tree = T::default();
        first(&mut tree);
        warm(tree)
    };
    Case::new(format!("{name}.cycles"), prepare, move |tree| ticks(tree, CYCLES, &each))
}

/// Robots in one process, each with a tree; all tick in each cycle.
fn robots<T: Tree + Default + 'static>(name: &str, count: usize) -> Case {
    let prepare = move || (0..count).map(|_| warm(T::default())).collect::<Vec<_>>();
    Case::new(format!("{name}.cycles"), prepare, |robots| {
        for now in CYCLES..2 * CYCLES {
            for tree in &mut *robots {
                black_box(tree).tick(Instant::from_millis(now));
            }
            slow_down(T::COUNT * robots.len());
        }
    })
}

/// All benchmarks of the framework.
pub(crate) fn cases() -> Vec<Case> {
    vec![
        tree::<One>("one"),
        tree::<Ten>("chain_of_ten"),
        tree::<Rarely>("chain_of_ten_none_due"),
        tree::<Hundred>("chain_of_a_hundred"),
        tree::<WideTen>("ten"),
        tree::<WideHundred>("a_hundred"),
        tree::<TenOfTen>("ten_of_ten"),
        tree::<TenOfHundred>("ten_of_a_hundred"),
        tree::<Diamond>("shared"),
        tree::<Switch>("switch"),
        changed::<Switch>("no_switch", |tree| tree.get_mut::<Root>().changes = false, |_, _| {}),
        tree::<Constants>("constants"),
        tree::<TunedOff>("tuned_off"),
        tree::<TunedOn>("tuned_on"),
        robots::<WideHundred>("ten_robots_of_a_hundred", 10),
        robots::<WideTen>("a_hundred_robots_of_ten", 100),
        changed::<Machine>("machine", |_| {}, |tree, now| tree.get_mut::<Ring>().input = now as u32),
        Case::new("machine_by_hand.cycles", ByHand::new, |machine| {
            for now in CYCLES..2 * CYCLES {
                let machine = black_box(&mut *machine);
                machine.input = now as u32;
                machine.step(1000 * now);
            }
        }),
    ]
}
