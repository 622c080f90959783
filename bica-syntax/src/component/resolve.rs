//! From names of states to their indices.

use proc_macro2::Ident;

use super::model::{Component, Edge, Function, Hook, Machine, MachineState, Sources, Transition};
use crate::report::Report;
use crate::{text, wording};

/// Resolves every name; `None` if one is unknown or the initial state is not clear.
pub(crate) fn machine(component: &Component, report: &mut Report) -> Option<Machine> {
    let names = Names::of(component);
    let initial = initial(component, report);
    let mut states: Vec<MachineState> = component.states.iter().map(MachineState::of).collect();
    let mut known = true;
    known &= attach(&component.entries, &names, report, |state, hook| states[state].entries.push(hook));
    known &= attach(&component.exits, &names, report, |state, hook| states[state].exits.push(hook));
    let mut edges = Vec::new();
    for transition in &component.transitions {
        known &= names.edges(transition, &mut edges, report);
    }
    known.then_some(Machine { initial: initial?, states, edges })
}

fn initial(component: &Component, report: &mut Report) -> Option<usize> {
    let mut marked = component.states.iter().enumerate().filter_map(|(at, state)| Some((at, state.initial.as_ref()?)));
    let Some((first, _)) = marked.next() else {
        let first = component.states.first()?;
        report.add(&first.function.name, wording::no_initial(&text::name(&first.function.name)));
        return None;
    };
    if let Some((_, second)) = marked.next() {
        report.add(second, wording::two_initial(&text::name(&component.states[first].function.name)));
        return None;
    }
    Some(first)
}

/// Adds each hook to its states; returns whether all of them are known.
fn attach(hooks: &[Hook], names: &Names, report: &mut Report, mut put: impl FnMut(usize, Function)) -> bool {
    let mut known = true;
    for hook in hooks {
        let mut seen = Vec::new();
        for name in &hook.states {
            match names.find(name, report) {
                Some(state) if seen.contains(&state) => report.add(name, wording::TWICE),
                Some(state) => {
                    seen.push(state);
                    put(state, hook.function.clone());
                }
                None => known = false,
            }
        }
    }
    known
}

impl MachineState {
    fn of(state: &super::model::State) -> Self {
        Self { body: state.function.clone(), last: state.last, entries: Vec::new(), exits: Vec::new() }
    }
}

struct Names(Vec<String>);

impl Names {
    fn of(component: &Component) -> Self {
        Self(component.states.iter().map(|state| text::name(&state.function.name)).collect())
    }

    fn find(&self, name: &Ident, report: &mut Report) -> Option<usize> {
        let wrong = text::name(name);
        let found = self.0.iter().position(|state| *state == wrong);
        if found.is_none() {
            let nearest = text::nearest(&wrong, self.0.iter().map(String::as_str));
            let known = self.0.iter().map(|state| format!("`{state}`")).collect::<Vec<_>>().join(", ");
            report.add(name, wording::unknown_state(&wrong, nearest, &known));
        }
        found
    }

    /// Adds one edge for each state that the transition leaves; returns whether all names are known.
    fn edges(&self, transition: &Transition, edges: &mut Vec<Edge>, report: &mut Report) -> bool {
        let to = self.find(&transition.to, report);
        let from: Vec<Option<usize>> = match &transition.from {
            Sources::Any => (0..self.0.len()).filter(|state| Some(*state) != to).map(Some).collect(),
            Sources::These(names) => names.iter().map(|name| self.find(name, report)).collect(),
        };
        let Some(to) = to else { return false };
        if from.is_empty() {
            report.add(&transition.attribute, wording::from_nowhere(&self.0[to]));
            return false;
        }
        for (place, from) in from.iter().enumerate() {
            let Some(from) = *from else { return false };
            let same =
                |edge: &Edge| edge.from == from && edge.to == to && edge.condition.name == transition.function.name;
            if edges.iter().any(same) {
                let name = if let Sources::These(names) = &transition.from { names.get(place) } else { None };
                report.add(name.unwrap_or(&transition.to), wording::TWICE);
                continue;
            }
            let condition = transition.function.clone();
            edges.push(Edge { condition, from, to, after_ms: transition.after_ms });
        }
        true
    }
}
