//! Rule 7, transitions: they are evaluated in source order, and at most one is taken per run. No cycle is lost: the new
//! state's children are visited and its body runs in the same run.

use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::TestTree;
use crate::trees::on_trees;

on_trees!(machine(Stress { flags: 12, rates: 1, ..Stress::default() }));

fn machine<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for index in 0..T::COUNT {
        let mut entered = 0;
        let mut before = None;
        for cycle in cycles {
            if cycle.has(&Event::Start(index)) && !T::GRAPH.nodes[index].resume || before.is_none() {
                entered = cycle.now;
            }
            one_body_in_the_last_state::<T>(cycle, index)?;
            evaluated_in_order::<T>(cycle, index)?;
            if let Some((from, to)) = cycle.transition(index) {
                is_allowed::<T>(cycle, index, (from, to), cycle.now - entered)?;
                entered = cycle.now;
            }
            before = cycle.states[index];
        }
    }
    Ok(())
}

fn one_body_in_the_last_state<T: TestTree>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
    let node = &T::GRAPH.nodes[index];
    let current = cycle.states[index].map_or("", |state| node.states[state].name);
    let bodies = cycle.events.iter().filter_map(|event| match event {
        Event::Body { of, state, .. } if *of == node.name => Some(*state),
        _ => None,
    });
    let transitions = cycle.events.iter().filter(|event| matches!(event, Event::Transition(of, ..) if *of == index));
    prop_assert!(transitions.count() <= usize::from(cycle.has(&Event::Run(index))));
    let expected: &[&str] = if cycle.has(&Event::Run(index)) { &[current] } else { &[] };
    prop_assert_eq!(bodies.collect::<Vec<_>>(), expected);
    Ok(())
}

/// Checks that transitions are evaluated in source order, each once, and none after the one that is taken.
fn evaluated_in_order<T: TestTree>(cycle: &Cycle, index: usize) -> Result<(), TestCaseError> {
    let node = &T::GRAPH.nodes[index];
    let evaluated = cycle.events.iter().filter_map(|event| match event {
        Event::Evaluated { by, transition, .. } if *by == node.name => Some(*transition),
        _ => None,
    });
    let from = cycle.transition(index).map_or(cycle.states[index], |(from, _)| Some(from));
    let mut order = node.transitions.iter().filter(|way| Some(way.from) == from).map(|way| way.name);
    for name in evaluated {
        prop_assert!(order.any(|other| other == name));
    }
    Ok(())
}

/// Checks that there is such a transition, that its timer has expired, and that the children of the new state are
/// active.
fn is_allowed<T: TestTree>(
    cycle: &Cycle,
    index: usize,
    (from, to): (usize, usize),
    stayed: u64,
) -> Result<(), TestCaseError> {
    let node = &T::GRAPH.nodes[index];
    let mut ways = node.transitions.iter().filter(|way| (way.from, way.to) == (from, to));
    prop_assert!(ways.any(|way| way.after_ms.is_none_or(|ms| stayed >= u64::from(ms) * 1000)));
    for link in node.links.iter().filter(|link| link.state == Some(to)) {
        prop_assert!(cycle.active.contains(&link.to));
    }
    Ok(())
}
