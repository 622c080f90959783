//! Playing of a script on a tree and on its model.

use bica::graph::{Link, LinkKind};
use bica::prelude::*;
use bica::tree::Status;
use proptest::prelude::*;

use super::event::{Event, Recorder, take_events};
use super::model::Model;
use super::script::{Action, Script};
use super::test_tree::TestTree;

/// Recorded cycle.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cycle {
    pub(crate) now: u64,
    pub(crate) events: Vec<Event>,
    /// Components that were visited.
    pub(crate) active: Vec<usize>,
    /// State of each component at the end of the cycle.
    pub(crate) states: Vec<Option<usize>>,
    /// Hold of each component.
    pub(crate) holds: Vec<Hold>,
    /// Rate of each component at the end of the cycle.
    pub(crate) hz: Vec<Option<f32>>,
    /// Components whose rate was set in the cycle or since the previous one.
    pub(crate) rated: Vec<usize>,
}

impl Cycle {
    /// Position of an event in the cycle.
    pub(crate) fn at(&self, expected: &Event) -> Option<usize> {
        self.events.iter().position(|event| event == expected)
    }

    pub(crate) fn has(&self, expected: &Event) -> bool {
        self.events.contains(expected)
    }

    /// Position of the visit of a component.
    pub(crate) fn visit(&self, index: usize) -> Option<usize> {
        self.at(&Event::Run(index)).or_else(|| self.at(&Event::Skip(index)))
    }

    /// Transition of a component: from and to.
    pub(crate) fn transition(&self, index: usize) -> Option<(usize, usize)> {
        self.events.iter().find_map(|event| match *event {
            Event::Transition(of, from, to) if of == index => Some((from, to)),
            _ => None,
        })
    }

    /// Links of a visited component that are in force in the cycle: those of its state, and those that it read before a
    /// transition.
    pub(crate) fn links<T: TestTree>(&self, index: usize) -> impl Iterator<Item = &'static Link> {
        let (state, left) = (self.states[index], self.transition(index).map(|(from, _)| from));
        T::GRAPH.nodes[index].links.iter().filter(move |link| {
            let read_before = link.state == left && link.kind == LinkKind::Requirement;
            link.state.is_none() || link.state == state || read_before
        })
    }
}

/// Plays the script, compares all events with the model, and returns them.
pub(crate) fn play<T: TestTree>(script: &Script) -> Result<Vec<Cycle>, TestCaseError> {
    take_events();
    let mut tree = T::default();
    let mut model = Model::new(T::GRAPH, T::HOOKS);
    let mut now = 1_000_000;
    let mut cycles = Vec::new();
    for (number, tick) in script.iter().enumerate() {
        let actions = tick.actions.iter().map(|&(index, action)| (index.index(T::COUNT), action));
        actions.clone().for_each(|(index, action)| perform(&mut tree, &mut model, index, action));
        now = tick.clock.after(now);
        tree.tick_with(Instant::from_ticks(now), &mut Recorder);
        let events = take_events();
        let differs = model.tick(now, events.clone());
        prop_assert!(differs.is_ok(), "cycle {}: {}\n{:#?}", number, differs.unwrap_err(), events);
        compare(&tree, &model)?;
        let from_parents = events.iter().filter_map(|event| match event {
            Event::RateSet { of, .. } => Some(model.named(of)),
            _ => None,
        });
        let from_outside = actions
            .filter(|(_, action)| matches!(action, Action::Rate(_) | Action::RateAt(_) | Action::Reset))
            .map(|(index, _)| index);
        cycles.push(Cycle {
            now,
            active: tree.active().map(ComponentId::index).collect(),
            states: (0..T::COUNT).map(|index| tree.state(ComponentId::new(index))).collect(),
            holds: (0..T::COUNT).map(|index| tree.held(ComponentId::new(index))).collect(),
            hz: (0..T::COUNT).map(|index| tree.status(ComponentId::new(index)).and_then(|status| status.hz)).collect(),
            rated: from_parents.chain(from_outside).collect(),
            events,
        });
    }
    Ok(cycles)
}

fn perform<T: TestTree>(tree: &mut T, model: &mut Model, index: usize, action: Action) {
    match action {
        Action::Flags(flags) => (tree.unit(index).flags, model.components[index].flags) = (flags, flags),
        Action::Rate(hz) => {
            tree.set_rate(index, hz);
            model.set_rate(index, hz);
        }
        Action::RateAt(hz) => {
            tree.set_rate_at(ComponentId::new(index), hz);
            model.set_rate(index, hz);
        }
        Action::Reset => {
            tree.reset_rate(index);
            model.components[index].hz = T::GRAPH.nodes[index].hz;
        }
        Action::SetChildRate(hz) => tree.unit(index).requested_rate = Some(hz),
        Action::Hold(hold) => {
            tree.hold_at(ComponentId::new(index), hold);
            model.components[index].hold = hold;
        }
    }
}

/// Compares the status of each component between two cycles.
fn compare<T: TestTree>(tree: &T, model: &Model) -> Result<(), TestCaseError> {
    for (index, memory) in model.components.iter().enumerate() {
        let id = ComponentId::new(index);
        let expected = Status {
            active: memory.active,
            held: memory.hold,
            state: memory.state,
            since: memory.started.then(|| Instant::from_ticks(memory.entered)),
            hz: memory.hz,
        };
        prop_assert_eq!(tree.status(id), Some(expected));
        prop_assert_eq!(
            (tree.is_active(id), tree.held(id), tree.state(id)),
            (expected.active, expected.held, expected.state)
        );
    }
    Ok(())
}
