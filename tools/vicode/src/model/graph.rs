//! The machine with all names resolved, as the macro puts it into `GRAPH`.

use std::collections::BTreeMap;

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
}

impl Graph {
    /// The graph of a component. What names an unknown state is left out.
    #[must_use]
    pub fn of(component: &Component) -> Self {
        let mut graph = Self { links: Vec::new(), edges: edges(component) };
        if !component.is_machine() {
            graph.links = links(None, component.step.iter());
            return graph;
        }
        for (index, state) in component.states.iter().enumerate() {
            let left: Vec<&str> =
                graph.edges.iter().filter(|edge| edge.from == index).map(|edge| edge.name.as_str()).collect();
            let conditions = component.transitions.iter().map(|transition| &transition.function);
            let conditions = conditions.filter(|function| left.contains(&function.name.text.as_str()));
            let links = links(Some(index), own_functions(component, state).chain(conditions));
            graph.links.extend(links);
        }
        graph
    }
}

/// The links of a state and of its hooks, without those of the transitions that leave it.
pub(crate) fn own_links(component: &Component, state: usize) -> Vec<Link> {
    component.states.get(state).map_or_else(Vec::new, |one| links(Some(state), own_functions(component, one)))
}

/// From and to of the transitions that name the states that they leave.
pub(crate) fn named_edges(component: &Component) -> Vec<(usize, usize)> {
    let places = places(component);
    let find = |name: &Name| places.get(name.text.as_str()).copied();
    let mut edges = Vec::new();
    for arrow in component.transitions.iter().flat_map(|transition| &transition.arrows) {
        let (Some(to), Sources::These(names)) = (arrow.to.as_ref().and_then(find), &arrow.from) else { continue };
        edges.extend(names.iter().filter_map(find).map(|from| (from, to)));
    }
    edges
}

/// The functions of a state that do not depend on the transitions: its own and those of its hooks.
fn own_functions<'a>(component: &'a Component, state: &'a State) -> impl Iterator<Item = &'a Function> {
    let name = &state.function.name.text;
    let hooks = component.hooks.iter().filter(move |hook| hook.states.iter().any(|one| one.text == *name));
    [&state.function].into_iter().chain(hooks.map(|hook| &hook.function))
}

/// Index of each state by its name: of the first one, if several have it.
fn places(component: &Component) -> BTreeMap<&str, usize> {
    let mut places = BTreeMap::new();
    for (index, state) in component.states.iter().enumerate() {
        places.entry(state.function.name.text.as_str()).or_insert(index);
    }
    places
}

fn edges(component: &Component) -> Vec<Edge> {
    let places = places(component);
    let find = |name: &Name| places.get(name.text.as_str()).copied();
    let mut edges = Vec::new();
    for transition in &component.transitions {
        for arrow in &transition.arrows {
            let Some(to) = arrow.to.as_ref().and_then(find) else { continue };
            let from: Vec<usize> = match &arrow.from {
                Sources::Any => (0..component.states.len()).filter(|state| *state != to).collect(),
                Sources::These(names) => names.iter().filter_map(find).collect(),
            };
            let after_ms = arrow.after_ms.map(|(value, _)| value);
            let name = &transition.function.name.text;
            edges.extend(from.into_iter().map(|from| Edge { name: name.clone(), from, to, after_ms }));
        }
    }
    edges
}

/// The links of functions that run together: each child once, as a modulation if one of them writes it.
fn links<'a>(state: Option<usize>, functions: impl Iterator<Item = &'a Function>) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    for (_, kind, child) in functions.flat_map(Function::links) {
        match links.iter_mut().find(|link| link.child == child) {
            Some(link) if kind == LinkKind::Modulation => link.kind = kind,
            Some(link) if link.kind == LinkKind::Rate => link.kind = kind,
            Some(_) => {}
            None => links.push(Link { state, child: child.to_owned(), kind }),
        }
    }
    for link in &mut links {
        if link.kind == LinkKind::Rate {
            link.kind = LinkKind::Modulation;
        }
    }
    links
}
