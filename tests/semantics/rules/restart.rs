//! Rule 6, restart: a machine that was latent starts in its initial state, unless it resumes.

use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::{Hook, TestTree};
use crate::trees::on_trees;

on_trees!(restart(Stress { flags: 9, holds: 1, ..Stress::default() }));

fn restart<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for (index, node) in T::GRAPH.nodes.iter().enumerate() {
        let initial = node.states.iter().position(|state| state.initial);
        let mut last = None;
        for cycle in cycles {
            let begins = cycle.transition(index).map_or(cycle.states[index], |(from, _)| Some(from));
            if cycle.has(&Event::Start(index)) {
                let goes_on = last.filter(|_| node.resume);
                prop_assert_eq!(begins, goes_on.unwrap_or(initial));
                prop_assert_eq!(has_entry::<T>(cycle, index, begins), goes_on.is_none());
            } else {
                prop_assert_eq!(
                    begins,
                    last.unwrap_or_default(),
                    "a component that is latent or stays active keeps its state"
                );
            }
            last = cycle.states[index].map(|_| cycle.states[index]);
        }
    }
    Ok(())
}

/// Whether an entry hook of the state was called before the machine left it; true if the state has no entry hooks.
fn has_entry<T: TestTree>(cycle: &Cycle, index: usize, state: Option<usize>) -> bool {
    let node = &T::GRAPH.nodes[index];
    let is_entry =
        |hook: &&Hook| hook.of == node.name && hook.entry && state.is_some_and(|at| hook.state == node.states[at].name);
    let entries: Vec<_> = T::HOOKS.iter().filter(is_entry).collect();
    let stays = cycle.events.iter().take_while(|event| !matches!(event, Event::Transition(of, ..) if *of == index));
    let called = stays.into_iter().any(|event| match event {
        Event::Hook { of, hook, .. } => *of == node.name && entries.iter().any(|entry| entry.name == *hook),
        _ => false,
    });
    called || entries.is_empty() && !node.resume
}
