//! The machine with all names resolved, as the macro puts it into `GRAPH`.

use super::{Component, Function, LinkKind, Name, Sources, State};

/// Links and transitions of a component, by indices of states.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Graph {
    /// Links, those of each state together.
    pub links: Vec<Link>,
    /// Transitions, in the order in which they are tried.
    pub edges: Vec<Edge>,
}

/// A link of a component or of one of its states.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Link {
    /// The state; `None` without a machine.
    pub state: Option<usize>,
    /// Type of the child.
    pub child: String,
    /// Requirement or modulation; a rate is a modulation.
    pub kind: LinkKind,
}

/// A transition from one state to one other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Name of the condition.
    pub name: String,
    /// State that it leaves.
    pub from: usize,
    /// State that it enters.
    pub to: usize,
    /// Least time in the state before it, ms.
    pub after_ms: Option<u32>,
    /// Whether the attribute names all states by `*`.
    pub from_any: bool,
}

impl Graph {
    /// The graph of a component. What names an unknown state is left out.
    #[must_use]
    pub fn of(component: &Component) -> Self {
        let edges = edges(component);
        if !component.is_machine() {
            return Self { links: links(None, component.step.iter()), edges };
        }
        let of_state = |(index, state): (usize, &State)| {
            let leaves = |name: &str| edges.iter().any(|edge| edge.from == index && edge.name == name);
            let conditions = component.transitions.iter().map(|transition| &transition.function);
            let conditions = conditions.filter(|function| leaves(&function.name.text));
            links(Some(index), own_functions(component, state).chain(conditions))
        };
        Self { links: component.states.iter().enumerate().flat_map(of_state).collect(), edges }
    }
}

/// The links of a state and of its hooks, without those of the transitions that leave it.
pub(crate) fn own_links(component: &Component, state: usize) -> Vec<Link> {
    component.states.get(state).map_or_else(Vec::new, |one| links(Some(state), own_functions(component, one)))
}

/// The functions of a state that do not depend on the transitions: its own and those of its hooks.
fn own_functions<'a>(component: &'a Component, state: &'a State) -> impl Iterator<Item = &'a Function> {
    let name = &state.function.name.text;
    let hooks = component.hooks.iter().filter(move |hook| hook.states.iter().any(|one| one.text == *name));
    [&state.function].into_iter().chain(hooks.map(|hook| &hook.function))
}

fn edges(component: &Component) -> Vec<Edge> {
    let names: Vec<&str> = component.states.iter().map(|state| &*state.function.name.text).collect();
    let find = |name: &Name| names.iter().position(|state| *state == name.text);
    let mut edges = Vec::new();
    for transition in &component.transitions {
        for arrow in &transition.arrows {
            let Some(to) = find(&arrow.to) else { continue };
            let from: Vec<usize> = match &arrow.from {
                Sources::Any => (0..names.len()).filter(|state| *state != to).collect(),
                Sources::These(names) => names.iter().filter_map(find).collect(),
            };
            let (after_ms, from_any) = (arrow.after_ms.map(|(value, _)| value), arrow.from == Sources::Any);
            let name = &transition.function.name.text;
            edges.extend(from.into_iter().map(|from| Edge { name: name.clone(), from, to, after_ms, from_any }));
        }
    }
    edges
}

/// The links of functions that run together: each child once, as a modulation if one of them writes it.
fn links<'a>(state: Option<usize>, functions: impl Iterator<Item = &'a Function>) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    for (_, kind, child) in functions.flat_map(Function::links) {
        match links.iter_mut().find(|link| link.child == child) {
            Some(link) if kind == LinkKind::Modulation || link.kind == LinkKind::Rate => link.kind = kind,
            Some(_) => {}
            None => links.push(Link { state, child: child.to_owned(), kind }),
        }
    }
    for link in links.iter_mut().filter(|link| link.kind == LinkKind::Rate) {
        link.kind = LinkKind::Modulation;
    }
    links
}
