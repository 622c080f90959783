//! The least time of a cycle, which other programs on the machine hardly touch; and whether the cost is linear.

use std::hint::black_box;
use std::time::Instant as Clock;

use bica::{Instant, Tree};

use bica_benches::trees::chain::{Hundred, Ten};
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::wide::{WideHundred, WideTen};

/// How often each tree is measured, in turn, and for how many cycles.
const ROUNDS: usize = 500;
const CYCLES: u64 = 1000;

/// A tree, and the least time of its cycle, ns.
struct Measured {
    name: &'static str,
    components: usize,
    tick: Box<dyn FnMut(Instant)>,
    least: f64,
}

fn measured<T: Tree>(name: &'static str, components: usize, mut tree: T) -> Measured {
    Measured { name, components, tick: Box::new(move |now| black_box(&mut tree).tick(now)), least: f64::INFINITY }
}

/// Measures and prints.
pub(crate) fn print() {
    let mut trees = [
        measured("ten in a chain", 10, Ten::new()),
        measured("a hundred in a chain", 100, Hundred::new()),
        measured("ten", 10, WideTen::new()),
        measured("a hundred, in ten chains", 100, WideHundred::new()),
        measured("ten of ten active", 10, TenOfTen::new()),
        measured("ten of a hundred active", 10, TenOfHundred::new()),
    ];
    let mut now = 0;
    for _ in 0..ROUNDS {
        for tree in &mut trees {
            let began = Clock::now();
            for _ in 0..CYCLES {
                now += 1;
                (tree.tick)(Instant::from_millis(now));
            }
            tree.least = tree.least.min(began.elapsed().as_nanos() as f64 / CYCLES as f64);
        }
    }
    println!("least time, ns{:>26}{:>16}{:>12}", "a cycle", "a component", "ratio");
    for pair in trees.chunks(2) {
        let each = |tree: &Measured| tree.least / tree.components as f64;
        let first = pair.first().map_or(f64::NAN, each);
        for tree in pair {
            println!("{:<26}{:>14.1}{:>16.2}{:>12.2}", tree.name, tree.least, each(tree), each(tree) / first);
        }
    }
}
