//! Rule 5, active: visited in this cycle. A component that becomes active starts and is due at once; one that is not
//! visited any more stops at the end of the cycle, activators first.

use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::rig::Rig;
use crate::support::script::Stress;
use crate::trees::on_trees;

on_trees!(active(Stress { flags: 8, rates: 2, ..Stress::default() }));

fn active<T: Rig>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    let mut before = Vec::new();
    for cycle in cycles {
        prop_assert_eq!(&cycle.active, &reached::<T>(cycle, vec![T::GRAPH.root]));
        for index in 0..T::COUNT {
            let (was, is) = (before.contains(&index), cycle.active.contains(&index));
            starts::<T>(cycle, index, is && !was)?;
            stops::<T>(cycle, index, was && !is)?;
            prop_assert_eq!(cycle.visit(index).is_some(), is);
        }
        stops_from_above::<T>(cycle)?;
        before.clone_from(&cycle.active);
    }
    Ok(())
}

/// What is reached from some components over the links that hold.
pub(crate) fn reached<T: Rig>(cycle: &Cycle, from: Vec<usize>) -> Vec<usize> {
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

fn starts<T: Rig>(cycle: &Cycle, index: usize, started: bool) -> Result<(), TestCaseError> {
    let name = T::GRAPH.nodes[index].name;
    prop_assert_eq!(cycle.has(&Event::Start(index)), started);
    prop_assert_eq!(cycle.has(&Event::Started(name)), started);
    if started {
        prop_assert!(cycle.has(&Event::Run(index)), "due at once");
        prop_assert!(cycle.at(&Event::Started(name)) < cycle.visit(index));
    }
    Ok(())
}

fn stops<T: Rig>(cycle: &Cycle, index: usize, stopped: bool) -> Result<(), TestCaseError> {
    let name = T::GRAPH.nodes[index].name;
    prop_assert_eq!(cycle.has(&Event::Stop(index)), stopped);
    prop_assert_eq!(cycle.has(&Event::Stopped(name)), stopped);
    Ok(())
}

/// All stops come behind all else, and an activator's before those of what it can activate.
fn stops_from_above<T: Rig>(cycle: &Cycle) -> Result<(), TestCaseError> {
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
