//! Rule 2, order: visit required children; then, if due, the own step; then visit modulated children.

use bica::graph::LinkKind;
use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::rig::Rig;
use crate::support::script::Stress;
use crate::trees::on_trees;

on_trees!(order(Stress { flags: 6, rates: 2, ..Stress::default() }));

fn order<T: Rig>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
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

/// Whatever a component reads was visited before its code went on.
fn required_before<T: Rig>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
    let began = cycle.events.iter().rposition(|event| *event == Event::Begin(index));
    for link in cycle.links::<T>(index).filter(|link| link.kind == LinkKind::Requirement) {
        prop_assert!(cycle.visit(link.to) < began || began.is_none());
    }
    Ok(())
}

/// A component that is only written was visited behind the code of the first that writes it.
fn modulated_after<T: Rig>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
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
