//! Rule 2, order: required children are visited first; then the component's own step runs if it is due; then modulated
//! children are visited.

use bica::graph::LinkKind;
use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::TestTree;
use crate::trees::on_trees;

on_trees!(order(Stress { flags: 6, rates: 2, ..Stress::default() }));

fn order<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for cycle in cycles {
        for &index in &cycle.active {
            required_before::<T>(cycle, index)?;
            if index != T::GRAPH.root {
                modulated_after::<T>(cycle, index)?;
            }
        }
    }
    Ok(())
}

/// Checks that all components that are read were visited before.
fn required_before<T: TestTree>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
    let began = cycle.events.iter().rposition(|event| *event == Event::Begin(index));
    for link in cycle.links::<T>(index).filter(|link| link.kind == LinkKind::Requirement) {
        prop_assert!(cycle.visit(link.to) < began || began.is_none());
    }
    Ok(())
}

/// Checks that a component that is only written is visited after the code of the first component that writes it.
fn modulated_after<T: TestTree>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
    let activators = cycle.active.iter().filter(|&&from| cycle.links::<T>(from).any(|link| link.to == index));
    let activators: Vec<usize> = activators.copied().collect();
    let is_read =
        |from: &usize| cycle.links::<T>(*from).any(|link| link.to == index && link.kind == LinkKind::Requirement);
    if !activators.iter().any(is_read) {
        let ends = activators.iter().filter_map(|&from| cycle.at(&Event::End(from)).or(cycle.at(&Event::Skip(from))));
        prop_assert!(cycle.visit(index) > ends.min());
    }
    Ok(())
}
