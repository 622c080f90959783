//! From names of states to their indices: for the macro and for tools.

use proc_macro2::Ident;

use super::model::{Component, Edge, End, Function, Guard, Hook, Machine, MachineState, Sources, Transition};
use crate::code::Code;
use crate::report::Report;
use crate::{text, wording};

/// What has a name in the text.
pub trait Named {
    /// Returns the name without the `r#` of a raw identifier.
    fn text(&self) -> String;
}

impl Named for Ident {
    fn text(&self) -> String {
        text::name(self)
    }
}

impl Named for Function {
    fn text(&self) -> String {
        text::name(&self.name)
    }
}

impl<T: Named> Named for &T {
    fn text(&self) -> String {
        (*self).text()
    }
}

/// A state machine as its attributes write it, with functions `F` and names `N` of states.
pub struct Written<'a, F, N> {
    /// Functions of the states, each with whether it is marked as last, and with which result.
    pub states: Vec<(F, bool, Option<End>)>,
    /// Entry hooks with the states that they name.
    pub entries: Vec<(F, &'a [N])>,
    /// Exit hooks with the states that they name.
    pub exits: Vec<(F, &'a [N])>,
    /// Functions before the transitions, with the states that they name.
    pub hooks_before: Vec<(F, &'a [N])>,
    /// Transitions.
    pub arrows: Vec<Arrow<'a, F, N>>,
}

/// A transition: condition, states before, state after, what it waits for.
pub type Arrow<'a, F, N> = (F, &'a Sources<N>, &'a N, Guard);

/// A name or a transition that is left out.
pub enum Omitted<'a, N> {
    /// The name of no state.
    Unknown(&'a N),
    /// The second mention of a state.
    Twice(&'a N),
    /// The mention of a state that has a function before its transitions already.
    SecondBefore(&'a N),
    /// The transition of this index, from all other states to the only one.
    FromNowhere(usize),
}

impl<'a, F: Clone + Named, N: Named> Written<'a, F, N> {
    /// States and edges with all names resolved; `omitted` gets what is left out.
    pub fn resolve(&self, mut omitted: impl FnMut(Omitted<'a, N>)) -> (Vec<MachineState<F>>, Vec<Edge<F>>) {
        let (names, mut states): (Vec<String>, Vec<MachineState<F>>) =
            self.states.iter().map(MachineState::named).unzip();
        for (hook, named) in &self.entries {
            each(&names, named, &mut omitted, |state, _| states[state].entries.push(hook.clone()));
        }
        for (hook, named) in &self.exits {
            each(&names, named, &mut omitted, |state, _| states[state].exits.push(hook.clone()));
        }
        let mut seconds = Vec::new();
        for (hook, named) in &self.hooks_before {
            each(&names, named, &mut omitted, |state, name| match &mut states[state].before {
                Some(_) => seconds.push(name),
                free => *free = Some(hook.clone()),
            });
        }
        for name in seconds {
            omitted(Omitted::SecondBefore(name));
        }
        let mut edges = Vec::new();
        for index in 0..self.arrows.len() {
            self.add_edges(&names, index, &mut edges, &mut omitted);
        }
        (states, edges)
    }

    /// Adds one edge for each state that a transition leaves.
    fn add_edges(
        &self,
        names: &[String],
        index: usize,
        edges: &mut Vec<Edge<F>>,
        omitted: &mut impl FnMut(Omitted<'a, N>),
    ) {
        let (condition, sources, target, guard) = &self.arrows[index];
        let to = find(names, *target, omitted);
        let from: Vec<(Option<usize>, &N)> = match sources {
            Sources::Any => (0..names.len()).map(Some).filter(|from| *from != to).map(|from| (from, *target)).collect(),
            Sources::These(named) => named.iter().map(|name| (find(names, name, omitted), name)).collect(),
        };
        let Some(to) = to else { return };
        let any = matches!(sources, Sources::Any);
        if any && from.is_empty() {
            omitted(Omitted::FromNowhere(index));
        }
        for (from, name) in from.into_iter().filter_map(|(from, name)| Some((from?, name))) {
            let is_same = |edge: &Edge<F>| {
                let is_guarded_alike = !guard.bare || edge.guard == *guard;
                (edge.from, edge.to) == (from, to) && edge.condition.text() == condition.text() && is_guarded_alike
            };
            if edges.iter().any(is_same) {
                omitted(Omitted::Twice(name));
            } else {
                edges.push(Edge { condition: condition.clone(), from, to, guard: guard.clone(), any });
            }
        }
    }
}

impl<F: Clone + Named> MachineState<F> {
    /// A state without hooks, and its name.
    fn named((body, last, end): &(F, bool, Option<End>)) -> (String, Self) {
        let (last, end) = (*last, *end);
        let state = Self { body: body.clone(), last, end, entries: Vec::new(), exits: Vec::new(), before: None };
        (body.text(), state)
    }
}

/// The index of the state of that name.
fn find<'a, N: Named>(names: &[String], name: &'a N, omitted: &mut impl FnMut(Omitted<'a, N>)) -> Option<usize> {
    let found = names.iter().position(|state| *state == name.text());
    if found.is_none() {
        omitted(Omitted::Unknown(name));
    }
    found
}

/// Calls `put` with each state that a hook names, and its name there.
fn each<'a, N: Named>(
    names: &[String],
    named: &'a [N],
    omitted: &mut impl FnMut(Omitted<'a, N>),
    mut put: impl FnMut(usize, &'a N),
) {
    let mut seen = Vec::new();
    for name in named {
        match find(names, name, omitted) {
            Some(state) if seen.contains(&state) => omitted(Omitted::Twice(name)),
            Some(state) => {
                seen.push(state);
                put(state, name);
            }
            None => {}
        }
    }
}

/// Resolves every name; `None` if one is unknown or the initial state is not clear.
pub(crate) fn machine(component: &Component, report: &mut Report) -> Option<Machine> {
    let written = Written {
        states: component.states.iter().map(|state| (state.function.clone(), state.last, state.end)).collect(),
        entries: component.entries.iter().map(Hook::written).collect(),
        exits: component.exits.iter().map(Hook::written).collect(),
        hooks_before: component.hooks_before.iter().map(Hook::written).collect(),
        arrows: component.transitions.iter().map(Transition::written).collect(),
    };
    let initial = initial(component, report);
    let mut is_known = true;
    let (states, edges) = written.resolve(|omitted| {
        is_known &= matches!(omitted, Omitted::Twice(_) | Omitted::SecondBefore(_));
        match omitted {
            Omitted::Unknown(name) => report.add_code(name, unknown(component, name)),
            Omitted::Twice(name) => report.add(name, wording::TWICE),
            Omitted::SecondBefore(name) => report.add(name, wording::second_before(&text::name(name))),
            Omitted::FromNowhere(index) => {
                let transition = &component.transitions[index];
                report.add(&transition.attribute, wording::from_nowhere(&text::name(&transition.arrow.to)));
            }
        }
    });
    is_known.then_some(Machine { initial: initial?, states, edges })
}

impl Hook {
    fn written(&self) -> (Function, &[Ident]) {
        (self.function.clone(), &self.states)
    }
}

impl Transition {
    fn written(&self) -> Arrow<'_, Function, Ident> {
        (self.function.clone(), &self.arrow.from, &self.arrow.to, self.arrow.guard.clone())
    }
}

fn unknown(component: &Component, name: &Ident) -> Code {
    let names: Vec<String> = component.states.iter().map(|state| state.function.text()).collect();
    let found = text::name(name);
    let meant = text::nearest(&found, names.iter().map(String::as_str)).map(str::to_owned);
    let known = names.iter().map(|state| format!("`{state}`")).collect::<Vec<_>>().join(", ");
    Code::UnknownState { found, meant, known }
}

fn initial(component: &Component, report: &mut Report) -> Option<usize> {
    let mut marked = component.states.iter().enumerate().filter_map(|(at, state)| Some((at, state.initial.as_ref()?)));
    let Some((first, _)) = marked.next() else {
        let name = &component.states.first()?.function.name;
        report.add_code(name, Code::NoInitial { first: text::name(name) });
        return None;
    };
    if let Some((_, second)) = marked.next() {
        report.add(second, wording::two_initial(&text::name(&component.states[first].function.name)));
        return None;
    }
    Some(first)
}
