//! Comparison of every small tree in every short sequence of cycles with a model.
//!
//! A **tree** has up to four components. Component 0 is the root, and links lead from lower to higher indices; every
//! directed acyclic graph with one root can be numbered like this. A component is a state machine with one to three
//! states. Each state has at most one link to each later component, a requirement or a modulation. A component runs in
//! every cycle, in every second or in every third; up to three components also in every second without declaring it.
//!
//! A **sequence** has six cycles of 10 ms. Before each cycle every machine gets the state that it has after its run
//! (its *next state*), and one component may be held active, held latent or released.
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
//! The product of all cases is too large. Each test explores one part of it completely. A [`Family`] describes the
//! part: number of components, their total number of states, all rates or none, with or without holds. A machine of two
//! states counts as one additional state, one of three as two. The tests print the number of compared trees and cycles.
//! Those that are ignored take minutes. Random trees test larger machines with rates, timers and values.

mod explore;
mod model;
mod shape;
mod tree;

use std::io::Write;

use explore::{Scope, sequences};
use shape::{COMPONENTS, RATES, RATES_AS_DECLARED, Rate, STATES, Shape, shapes};

/// Set of trees and sequences that are explored.
struct Family {
    name: &'static str,
    components: usize,
    /// Largest total number of additional states of the machines.
    additional_states: usize,
    /// Whether all rates are explored; otherwise every component runs in every cycle. Of four components none has a rate
    /// that it does not declare.
    rates: bool,
    holds: bool,
}

/// Returns all numbers of states of the components of a family.
fn state_counts(family: &Family) -> impl Iterator<Item = [usize; COMPONENTS]> {
    let (len, most) = (family.components, family.additional_states);
    let all = (0..STATES.pow(len as u32)).map(move |mut code| {
        let mut states = [1; COMPONENTS];
        for count in &mut states[..len] {
            *count = 1 + code % STATES;
            code /= STATES;
        }
        states
    });
    all.filter(move |states| states.iter().sum::<usize>() - COMPONENTS <= most)
}

/// Returns all rates of the components of a family.
fn rates(family: &Family) -> Vec<[Rate; COMPONENTS]> {
    // Four components would take three times as long with the last one.
    let kinds = if family.components < COMPONENTS { &RATES[..] } else { &RATES[..RATES_AS_DECLARED] };
    let count = if family.rates { kinds.len().pow(family.components as u32) } else { 1 };
    let each = (0..count).map(move |mut code| {
        let mut rates = [Rate::Every; COMPONENTS];
        for rate in &mut rates[..family.components] {
            *rate = kinds[code % kinds.len()];
            code /= kinds.len();
        }
        rates
    });
    each.collect()
}

/// Explores a family and prints the numbers of trees and cycles, even if the test harness captures the output.
fn explore(family: &Family) -> (u64, u64) {
    let (mut trees, mut cycles) = (0, 0);
    let rates = rates(family);
    for states in state_counts(family) {
        shapes(family.components, states, &mut |shape: Shape| {
            for &rates in &rates {
                trees += 1;
                cycles += sequences(&Shape { rates, ..shape }, Scope { holds: family.holds });
            }
        });
    }
    let line = format!("exhaustive semantics, {}: {trees} trees, {cycles} cycles compared\n", family.name);
    std::io::stderr().write_all(line.as_bytes()).expect("standard error can be written");
    (trees, cycles)
}

#[test]
fn up_to_three_components_with_all_rates() {
    for components in 1..=3 {
        let name = ["", "1 component", "2 components", "3 components"][components];
        explore(&Family { name, components, additional_states: 2, rates: true, holds: false });
    }
}

#[test]
fn three_components_with_three_machines() {
    explore(&Family {
        name: "3 components, up to 6 states",
        components: 3,
        additional_states: 3,
        rates: false,
        holds: false,
    });
}

#[test]
fn up_to_three_components_with_holds() {
    for components in 1..=3 {
        let name = ["", "1 component held", "2 components held", "3 components held"][components];
        let additional_states = [0, 2, 1, 0][components];
        explore(&Family { name, components, additional_states, rates: components < 3, holds: true });
    }
}

#[test]
fn four_components_with_all_rates() {
    explore(&Family {
        name: "4 components without machines",
        components: 4,
        additional_states: 0,
        rates: true,
        holds: false,
    });
}

#[test]
fn four_components_with_a_machine() {
    explore(&Family {
        name: "4 components, up to 5 states",
        components: 4,
        additional_states: 1,
        rates: false,
        holds: false,
    });
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_three_components_with_all_states() {
    explore(&Family {
        name: "3 components, up to 9 states",
        components: 3,
        additional_states: 6,
        rates: false,
        holds: false,
    });
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_four_components_with_two_machines() {
    explore(&Family {
        name: "4 components, up to 6 states",
        components: 4,
        additional_states: 2,
        rates: false,
        holds: false,
    });
}
