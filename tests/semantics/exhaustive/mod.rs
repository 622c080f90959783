//! Comparison of every small tree in every short sequence of cycles with a model.
//!
//! A **tree** has up to four components. Component 0 is the root, and links lead from lower to higher indices; every
//! directed acyclic graph with one root can be numbered like this. A component is a state machine with one to three
//! states. Each state has at most one link to each later component, a requirement or a modulation. A component runs in
//! every cycle, in every second or in every third; up to three components also in every second without declaring it.
//!
//! A **sequence** has cycles of 10 ms. Before each cycle every machine gets the state that it has after its run (its *next state*),
//! and components may be held active, held latent or released.
//!
//! Cases that are left out are covered by explored ones:
//!
//! - *Machines without some transition.* Every state has a transition to every other one. A machine without one of them
//!   behaves like a machine whose transition is never taken.
//! - *Several transitions whose conditions hold.* The first in the text is taken, and the engine receives only that
//!   one.
//! - *Components without states.* They behave like machines with one state.
//! - *The order of the states after the initial one*, which can be exchanged.
//! - *Next states of machines that do not run.* They are not read.
//! - *Sequences that lead to the same state of the model and of the engine.* Their continuations are the same.
//!
//! The product of all cases is too large to be explored tree by tree. So all trees with the same rates are explored at once, as the
//! graph of the states in which they can be ([`states`]). It covers every tree of up to four components with all rates, in sequences
//! of any length; with all holds, every tree of up to three components, and every tree of four components that run in every cycle; and
//! with holds of one component at a time, every tree of four components of which one does not run in every cycle.
//!
//! The tests print the numbers of compared trees, states and cycles. Those that take minutes are slow tests, which
//! `cargo xtask ci` runs. Random trees test larger machines with timers and values.

mod choice;
mod key;
mod model;
mod plan;
mod shape;
mod states;
mod subject;
mod tree;

use std::io::Write;
use std::sync::Mutex;
use std::thread;

use shape::{COMPONENTS, RATES, Rate, Shape};
use states::{Counts, States};

/// Prints a line, even if the test harness captures the output.
fn print(line: &str) {
    let line = format!("exhaustive semantics, {line}\n");
    std::io::stderr().write_all(line.as_bytes()).expect("standard error can be written");
}

/// Returns all rates of `len` components from a list.
fn all_rates(len: usize, kinds: &[Rate]) -> Vec<[Rate; COMPONENTS]> {
    let each = (0..kinds.len().pow(len as u32)).map(|mut code| {
        let mut rates = [Rate::Every; COMPONENTS];
        for rate in &mut rates[..len] {
            *rate = kinds[code % kinds.len()];
            code /= kinds.len();
        }
        rates
    });
    each.collect()
}

/// The framework counts one link to each component, or several: two forms of a visit.
const BOTH: [bool; 2] = [false, true];

/// Explores all trees of `len` components with each combination of rates and forms of visits, and prints the numbers.
fn explore(len: usize, rates: &[[Rate; COMPONENTS]], shared: &[bool], held: usize) {
    let work = rates.iter().flat_map(|&rates| shared.iter().map(move |&shared| (Shape::of_rates(len, rates), shared)));
    let (work, total) = (Mutex::new(work), Mutex::new(Counts::default()));
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let next = work.lock().expect("no other thread panics here").next();
                    let Some((shape, shared)) = next else { return };
                    let counts = subject::with_flags(&shape, shared, States { held });
                    *total.lock().expect("no other thread panics here") += counts;
                }
            });
        }
    });
    let counts = total.into_inner().expect("all threads ended");
    let (trees, kinds) = (
        states::trees(len) * rates.len() as u64,
        if held == 0 { String::new() } else { format!(" of holds of up to {held}") },
    );
    let Counts { states, cycles, depth } = counts;
    print(&format!(
        "{trees} trees of {len} components with all sequences{kinds}: {states} states, all reached in {depth} cycles; \
         {cycles} cycles compared"
    ));
}

#[test]
fn up_to_three_components_with_all_rates() {
    for len in 1..=3 {
        explore(len, &all_rates(len, &RATES), &BOTH, 0);
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_three_components_with_all_holds() {
    for len in 1..=3 {
        explore(len, &all_rates(len, &[Rate::Every, Rate::Half, Rate::Third]), &[true], len);
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_four_components_with_all_rates() {
    explore(COMPONENTS, &all_rates(COMPONENTS, &[Rate::Every, Rate::Half, Rate::Third]), &[true], 0);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_four_components_one_rated_one_held() {
    let mut rates = all_rates(COMPONENTS, &[Rate::Every, Rate::Half, Rate::Third]);
    rates.retain(|rates| rates.iter().filter(|rate| **rate != Rate::Every).count() == 1);
    explore(COMPONENTS, &rates, &[true], 1);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_four_components_with_all_holds() {
    explore(COMPONENTS, &[[Rate::Every; COMPONENTS]], &[true], COMPONENTS);
}
