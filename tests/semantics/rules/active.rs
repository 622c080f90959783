//! Rule 5, active: a component is active in a cycle if it is visited in it. A component that becomes active starts and
//! is due at once. One that is no longer visited stops at the end of the cycle, activators first.

use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::TestTree;
use crate::trees::on_trees;

on_trees!(active(Stress { flags: 8, rates: 2, ..Stress::default() }));

fn active<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    let mut before = Vec::new();
    for cycle in cycles {
        prop_assert_eq!(&cycle.active, &reached::<T>(cycle, vec![T::GRAPH.root]));
        for index in 0..T::COUNT {
            let (was, is) = (before.contains(&index), cycle.active.contains(&index));
            starts::<T>(cycle, index, is && !was)?;
            stops::<T>(cycle, index, was && !is)?;
            prop_assert_eq!(cycle.visit(index).is_some(), is);
        }
        stops_activators_first::<T>(cycle)?;
        before.clone_from(&cycle.active);
    }
    Ok(())
}

/// Returns the components reached from others over the links that hold in the cycle.
pub(crate) fn reached<T: TestTree>(cycle: &Cycle, from: Vec<usize>) -> Vec<usize> {
    let mut reached = Vec::new();
    let mut open = from;
    while let Some(index) = open.pop() {
        if cycle.holds[index] != bica::Hold::Latent && !reached.contains(&index) {
            reached.push(index);
            open.extend(cycle.links::<T>(index).map(|link| link.to));
        }
    }
    reached.sort_unstable();
    reached
}

fn starts<T: TestTree>(cycle: &Cycle, index: usize, started: bool) -> Result<(), TestCaseError> {
    let name = T::GRAPH.nodes[index].name;
    prop_assert_eq!(cycle.has(&Event::Start(index)), started);
    prop_assert_eq!(cycle.has(&Event::Started(name)), started);
    if started {
        prop_assert!(cycle.has(&Event::Run(index)), "due at once");
        prop_assert!(cycle.at(&Event::Started(name)) < cycle.visit(index));
    }
    Ok(())
}

fn stops<T: TestTree>(cycle: &Cycle, index: usize, stopped: bool) -> Result<(), TestCaseError> {
    let name = T::GRAPH.nodes[index].name;
    prop_assert_eq!(cycle.has(&Event::Stop(index)), stopped);
    prop_assert_eq!(cycle.has(&Event::Stopped(name)), stopped);
    Ok(())
}

/// Checks that all stops come last, and an activator's stop before those of the components that it can activate.
fn stops_activators_first<T: TestTree>(cycle: &Cycle) -> Result<(), TestCaseError> {
    let is_stop = |event: &Event| matches!(event, Event::Stop(_) | Event::Stopped(_));
    let first = cycle.events.iter().position(is_stop).unwrap_or(cycle.events.len() - 1);
    prop_assert!(cycle.events[first..cycle.events.len() - 1].iter().all(is_stop));
    for (from, node) in T::GRAPH.nodes.iter().enumerate() {
        for link in node.links {
            if let (Some(above), Some(below)) = (cycle.at(&Event::Stop(from)), cycle.at(&Event::Stop(link.to))) {
                prop_assert!(above < below);
            }
        }
    }
    Ok(())
}
