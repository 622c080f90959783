//! Execution of a script on a tree and on its model.

use std::panic::{AssertUnwindSafe, catch_unwind};

use bica::Status;
use bica::prelude::*;
use proptest::prelude::*;

use super::event::{Recorder, panic_after, take_events};
use super::graph::Model;
use super::script::{Action, Script};
use super::test_tree::TestTree;

/// Runs the script, and compares all events and the status of each component with the model.
pub(crate) fn play<T: TestTree>(script: &Script) -> Result<(), TestCaseError> {
    take_events();
    let mut tree = T::default();
    let mut model = Model::new(T::GRAPH, T::HOOKS, T::OUTCOMES);
    let mut now = 1_000_000;
    for (number, tick) in script.iter().enumerate() {
        for (index, action) in &tick.actions {
            perform(&mut tree, &mut model, index.index(T::COUNT), *action);
        }
        now = tick.clock.after(now);
        panic_after(tick.panics.unwrap_or(u32::MAX));
        let ticked = catch_unwind(AssertUnwindSafe(|| tree.tick_with(Instant::from_ticks(now), &mut Recorder)));
        panic_after(u32::MAX);
        let events = take_events();
        let differs = if ticked.is_ok() {
            model.tick(now, events.clone())
        } else {
            model.unwound(now, events.clone()).map(|()| take_over(&mut tree, &mut model))
        };
        prop_assert!(differs.is_ok(), "cycle {}: {}\n{:#?}", number, differs.unwrap_err(), events);
        if ticked.is_ok() {
            compare(&tree, &model)?;
        }
    }
    Ok(())
}

fn perform<T: TestTree>(tree: &mut T, model: &mut Model, index: usize, action: Action) {
    match action {
        Action::Flags(flags) => (tree.unit(index).flags, model.components[index].flags) = (flags, flags),
        Action::Rate(hz) => {
            tree.at_mut(index).unwrap().set_rate(Some(hz));
            model.set_rate(index, hz);
        }
        Action::Reset => {
            tree.at_mut(index).unwrap().set_rate(None);
            model.components[index].hz = T::GRAPH.nodes[index].hz;
        }
        Action::SetChildRate(hz) => tree.unit(index).requested_rate = Some(hz),
        Action::Hold(hold) => {
            tree.at_mut(index).unwrap().hold(hold);
            model.memories[index].hold = hold;
        }
        Action::Go(_) if T::GRAPH.nodes[index].states.is_empty() => {}
        Action::Go(state) => {
            let state = state.index(T::GRAPH.nodes[index].states.len());
            assert_eq!(tree.at_mut(index).unwrap().go(state).is_ok(), model.goes(index, state));
        }
    }
}

/// Gives the model what a function had changed before it panicked.
fn take_over<T: TestTree>(tree: &mut T, model: &mut Model) {
    for index in 0..T::COUNT {
        let status = tree.status(index).expect("a component");
        let unit = tree.unit(index);
        model.take_over(index, &status, (unit.value, unit.received));
    }
}

/// Compares the status of each component between two cycles.
fn compare<T: TestTree>(tree: &T, model: &Model) -> Result<(), TestCaseError> {
    for (index, (memory, data)) in model.memories.iter().zip(&model.components).enumerate() {
        let expected = Status {
            active: memory.active,
            held: memory.hold,
            state: memory.state,
            since: data.started.then(|| Instant::from_ticks(data.entered)),
            hz: data.hz,
        };
        prop_assert_eq!(tree.status(index), Some(expected));
    }
    Ok(())
}
