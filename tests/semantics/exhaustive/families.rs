//! Families of trees with constant links, each tree explored by itself.

use super::explore::{Scope, sequences};
use super::shape::{COMPONENTS, RATES, STATES, Shape, shapes};
use super::{all_rates, print};

/// Set of trees and sequences that are explored.
pub(crate) struct Family {
    name: &'static str,
    components: usize,
    /// Largest total number of additional states of the machines: one of two states counts as one, one of three as two.
    additional_states: usize,
    /// Whether all rates are explored; otherwise every component runs in every cycle.
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

/// Explores a family and prints the numbers of trees and cycles.
fn explore(family: &Family) {
    let (mut trees, mut cycles) = (0_u64, 0);
    let rates = all_rates(family.components, if family.rates { &RATES } else { &RATES[..1] });
    for states in state_counts(family) {
        shapes(family.components, states, &mut |shape: Shape| {
            for &rates in &rates {
                trees += 1;
                cycles += sequences(&Shape { rates, ..shape }, Scope { holds: family.holds });
            }
        });
    }
    print(&format!("{}: {trees} trees, {cycles} cycles compared", family.name));
}

#[test]
fn up_to_two_components_with_all_rates() {
    for (components, name) in [(1, "1 component"), (2, "2 components")] {
        explore(&Family { name, components, additional_states: 2, rates: true, holds: false });
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_up_to_two_components_with_all_rates_and_holds() {
    for (components, name) in [(1, "1 component held"), (2, "2 components held")] {
        explore(&Family { name, components, additional_states: components - 1, rates: true, holds: true });
    }
}

#[test]
fn three_components_with_two_machines() {
    let name = "3 components, up to 5 states";
    explore(&Family { name, components: 3, additional_states: 2, rates: false, holds: false });
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_three_components_with_three_machines() {
    let name = "3 components, up to 6 states";
    explore(&Family { name, components: 3, additional_states: 3, rates: false, holds: false });
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_four_components_with_a_machine() {
    let name = "4 components, up to 5 states";
    explore(&Family { name, components: 4, additional_states: 1, rates: false, holds: false });
}
