//! From names of states to their places.

use proc_macro2::Ident;

use super::model::{Component, From, Function, Hook, Machine, Place, Transition, Way};
use crate::language::report::Report;
use crate::language::{text, wording};

/// Resolves every name; `None` if one is unknown or the initial state is not clear.
pub(crate) fn machine(component: &Component, report: &mut Report) -> Option<Machine> {
    let names = Names::of(component);
    let initial = initial(component, report);
    let mut places: Vec<Place> = component
        .states
        .iter()
        .map(|state| Place { body: state.function.clone(), last: state.last, entries: Vec::new(), exits: Vec::new() })
        .collect();
    let mut known = true;
    known &= attach(&component.entries, &names, report, |state, hook| places[state].entries.push(hook));
    known &= attach(&component.exits, &names, report, |state, hook| places[state].exits.push(hook));
    let mut ways = Vec::new();
    for transition in &component.transitions {
        known &= names.ways(transition, &mut ways, report);
    }
    known.then_some(Machine { initial: initial?, states: places, ways })
}

fn initial(component: &Component, report: &mut Report) -> Option<usize> {
    let mut marked = component.states.iter().enumerate().filter_map(|(at, state)| Some((at, state.initial.as_ref()?)));
    let Some((first, _)) = marked.next() else {
        if !component.gaps {
            report.add(component.states.first().map(|state| &state.function.name), wording::NO_INITIAL);
        }
        return None;
    };
    if let Some((_, second)) = marked.next() {
        report.add(second, wording::two_initial(&component.states[first].function.name.to_string()));
        return None;
    }
    Some(first)
}

/// Hands each hook to its states; whether all of them are known.
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

struct Names(Vec<String>);

impl Names {
    fn of(component: &Component) -> Self {
        Self(component.states.iter().map(|state| state.function.name.to_string()).collect())
    }

    fn find(&self, name: &Ident, report: &mut Report) -> Option<usize> {
        let wrong = name.to_string();
        let found = self.0.iter().position(|state| *state == wrong);
        if found.is_none() {
            let nearest = text::nearest(&wrong, self.0.iter().map(String::as_str));
            let known = self.0.iter().map(|state| format!("`{state}`")).collect::<Vec<_>>().join(", ");
            report.add(name, wording::unknown_state(&wrong, nearest, &known));
        }
        found
    }

    /// Adds one way for each state that the transition leaves; whether all names are known.
    fn ways(&self, transition: &Transition, ways: &mut Vec<Way>, report: &mut Report) -> bool {
        let to = self.find(&transition.to, report);
        let from: Vec<Option<usize>> = match &transition.from {
            From::Any => (0..self.0.len()).filter(|state| Some(*state) != to).map(Some).collect(),
            From::These(names) => names.iter().map(|name| self.find(name, report)).collect(),
        };
        let Some(to) = to else { return false };
        for (place, from) in from.iter().enumerate() {
            let Some(from) = *from else { return false };
            let same = |way: &Way| way.from == from && way.to == to && way.condition.name == transition.function.name;
            if ways.iter().any(same) {
                let name = if let From::These(names) = &transition.from { names.get(place) } else { None };
                report.add(name.unwrap_or(&transition.to), wording::TWICE);
                continue;
            }
            let condition = transition.function.clone();
            ways.push(Way { condition, from, to, after_ms: transition.after_ms });
        }
        true
    }
}
