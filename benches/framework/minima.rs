//! Minimum time of a cycle, which other programs on the machine hardly affect, and its growth with the number of
//! components.

use std::hint::black_box;
use std::time::Instant as Clock;

use bica::{Instant, Tree};

use bica_benches::trees::chain::{Hundred, Ten};
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::wide::{WideHundred, WideTen};

/// Number of measurements of each tree; the trees alternate.
const ROUNDS: usize = 500;
/// Number of cycles of a measurement.
const CYCLES: u64 = 1000;

/// Tree with the minimum time of its cycle, ns.
struct Measured {
    name: &'static str,
    components: usize,
    tick: Box<dyn FnMut(Instant)>,
    minimum: f64,
}

fn measured<T: Tree>(name: &'static str, components: usize, mut tree: T) -> Measured {
    Measured { name, components, tick: Box::new(move |now| black_box(&mut tree).tick(now)), minimum: f64::INFINITY }
}

/// Measures all trees and prints the table.
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
            tree.minimum = tree.minimum.min(began.elapsed().as_nanos() as f64 / CYCLES as f64);
        }
    }
    println!("minimum time, ns{:>24}{:>16}{:>12}", "a cycle", "a component", "ratio");
    for pair in trees.chunks(2) {
        let each = |tree: &Measured| tree.minimum / tree.components as f64;
        let first = pair.first().map_or(f64::NAN, each);
        for tree in pair {
            println!("{:<26}{:>14.1}{:>16.2}{:>12.2}", tree.name, tree.minimum, each(tree), each(tree) / first);
        }
    }
}
