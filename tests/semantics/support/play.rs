//! Playing a script on a tree and on its model.

use bica::graph::{Link, LinkKind};
use bica::prelude::*;
use bica::tree::Status;
use proptest::prelude::*;

use super::event::{Event, Recorder, taken};
use super::model::Model;
use super::rig::Rig;
use super::script::{Act, Script};

/// A cycle as it happened.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cycle {
    pub(crate) now: u64,
    pub(crate) events: Vec<Event>,
    /// The components that were visited.
    pub(crate) active: Vec<usize>,
    /// The state of each component, at the end.
    pub(crate) states: Vec<Option<usize>>,
    /// How each component was held.
    pub(crate) holds: Vec<Hold>,
    /// The rate of each component, at the end.
    pub(crate) hz: Vec<Option<f32>>,
    /// Whose rate was set, in the cycle or since the one before.
    pub(crate) rated: Vec<usize>,
}

impl Cycle {
    /// Where something happened among the events.
    pub(crate) fn at(&self, wanted: &Event) -> Option<usize> {
        self.events.iter().position(|event| event == wanted)
    }

    pub(crate) fn has(&self, wanted: &Event) -> bool {
        self.events.contains(wanted)
    }

    /// Where a component was visited.
    pub(crate) fn visit(&self, index: usize) -> Option<usize> {
        self.at(&Event::Run(index)).or_else(|| self.at(&Event::Skip(index)))
    }

    /// The transition that a component took: from and to.
    pub(crate) fn transition(&self, index: usize) -> Option<(usize, usize)> {
        self.events.iter().find_map(|event| match *event {
            Event::Transition(of, from, to) if of == index => Some((from, to)),
            _ => None,
        })
    }

    /// The links of a visited component that held in the cycle: those of its state, and what it read before it took a
    /// transition.
    pub(crate) fn links<T: Rig>(&self, index: usize) -> impl Iterator<Item = &'static Link> {
        let (state, left) = (self.states[index], self.transition(index).map(|(from, _)| from));
        T::GRAPH.nodes[index].links.iter().filter(move |link| {
            let read_before = link.state == left && link.kind == LinkKind::Requirement;
            link.state.is_none() || link.state == state || read_before
        })
    }
}

/// Plays the script, compares all events with the model, and returns them.
pub(crate) fn play<T: Rig>(script: &Script) -> Result<Vec<Cycle>, TestCaseError> {
    taken();
    let mut tree = T::default();
    let mut model = Model::new(T::GRAPH, T::HOOKS);
    let mut now = 1_000_000;
    let mut cycles = Vec::new();
    for (number, tick) in script.iter().enumerate() {
        let acts = tick.acts.iter().map(|&(index, act)| (index.index(T::COUNT), act));
        acts.clone().for_each(|(index, act)| perform(&mut tree, &mut model, index, act));
        now = tick.clock.after(now);
        tree.tick_with(Instant::from_ticks(now), &mut Recorder);
        let events = taken();
        let differs = model.tick(now, events.clone());
        prop_assert!(differs.is_ok(), "cycle {}: {}\n{:#?}", number, differs.unwrap_err(), events);
        compare(&tree, &model)?;
        let by_parents = events.iter().filter_map(|event| match event {
            Event::Rated { of, .. } => Some(model.named(of)),
            _ => None,
        });
        let from_outside =
            acts.filter(|(_, act)| matches!(act, Act::Rate(_) | Act::RateAt(_) | Act::Reset)).map(|(index, _)| index);
        cycles.push(Cycle {
            now,
            active: tree.active().map(ComponentId::index).collect(),
            states: (0..T::COUNT).map(|index| tree.state(ComponentId::new(index))).collect(),
            holds: (0..T::COUNT).map(|index| tree.held(ComponentId::new(index))).collect(),
            hz: (0..T::COUNT).map(|index| tree.status(ComponentId::new(index)).and_then(|status| status.hz)).collect(),
            rated: by_parents.chain(from_outside).collect(),
            events,
        });
    }
    Ok(cycles)
}

fn perform<T: Rig>(tree: &mut T, model: &mut Model, index: usize, act: Act) {
    match act {
        Act::Flags(flags) => (tree.unit(index).flags, model.components[index].flags) = (flags, flags),
        Act::Rate(hz) => {
            tree.set_rate(index, hz);
            model.set_rate(index, hz);
        }
        Act::RateAt(hz) => {
            tree.set_rate_at(ComponentId::new(index), hz);
            model.set_rate(index, hz);
        }
        Act::Reset => {
            tree.reset_rate(index);
            model.components[index].hz = T::GRAPH.nodes[index].hz;
        }
        Act::Ask(hz) => tree.unit(index).asks = Some(hz),
        Act::Hold(hold) => {
            tree.hold_at(ComponentId::new(index), hold);
            model.components[index].hold = hold;
        }
    }
}

/// Compares the status of each component between two cycles.
fn compare<T: Rig>(tree: &T, model: &Model) -> Result<(), TestCaseError> {
    for (index, memory) in model.components.iter().enumerate() {
        let id = ComponentId::new(index);
        let wanted = Status {
            active: memory.active,
            held: memory.hold,
            state: memory.state,
            since: memory.started.then(|| Instant::from_ticks(memory.entered)),
            hz: memory.hz,
        };
        prop_assert_eq!(tree.status(id), Some(wanted));
        prop_assert_eq!(
            (tree.is_active(id), tree.held(id), tree.state(id)),
            (wanted.active, wanted.held, wanted.state)
        );
    }
    Ok(())
}
