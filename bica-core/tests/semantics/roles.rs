//! Roles: components that name what they need, and trees that name who provides it.

use bica_core::graph::{LinkKind, Roles};
use bica_macros::role;

use super::*;

#[role(crate = bica_core)]
pub(crate) trait Sight {
    fn distance(&self) -> u32;
}

#[role(crate = bica_core)]
pub(crate) trait Legs {
    fn walk(&mut self, steps: u32);

    fn steps(&self) -> u32;
}

pub(crate) struct Eye(u32);

#[component(crate = bica_core)]
impl Eye {
    const fn new() -> Self {
        Self(3)
    }

    fn step(&mut self) {
        self.0 += 1;
    }
}

impl Sight for Eye {
    fn distance(&self) -> u32 {
        self.0
    }
}

/// Sees with its feet.
pub(crate) struct Feet {
    steps: u32,
    visits: u32,
}

#[component(crate = bica_core)]
impl Feet {
    const fn new() -> Self {
        Self { steps: 0, visits: 0 }
    }

    fn step(&mut self) {
        self.visits += 1;
    }
}

impl Sight for Feet {
    fn distance(&self) -> u32 {
        10 * self.steps
    }
}

impl Legs for Feet {
    fn walk(&mut self, steps: u32) {
        self.steps = steps;
    }

    fn steps(&self) -> u32 {
        self.steps
    }
}

pub(crate) struct Follow {
    seen: u32,
}

#[component(crate = bica_core)]
impl Follow {
    const fn new() -> Self {
        Self { seen: 0 }
    }

    #[state(initial)]
    fn watch(&mut self, sight: &impl Sight, again: &impl super::roles::Legs) {
        self.seen = sight.distance() + again.steps();
    }

    #[state]
    fn go(&mut self, legs: &mut impl Legs) {
        legs.walk(self.seen);
    }

    #[transition(watch -> go)]
    fn near(&self, sight: &impl Sight) -> bool {
        sight.distance() > 4
    }

    #[transition(go -> watch)]
    fn far(&self, sight: &impl Sight, by_name: &Eye) -> bool {
        sight.distance() + by_name.0 > 100
    }
}

activation_tree! {
    pub(crate) struct Seeing {
        root: Follow,
        cycle_hz: 100,
        roles: { Sight: self::Eye, Legs: Feet },
        components: [Follow, Eye, Feet],
        crate: bica_core,
    }
}

activation_tree! {
    pub(crate) struct Feeling {
        root: Watch,
        cycle_hz: 100,
        roles: { super::roles::Sight: Feet, Legs: Feet, },
        components: [Watch, Feet],
        crate: bica_core,
    }
}

pub(crate) struct Watch {
    seen: u32,
}

#[component(crate = bica_core)]
impl Watch {
    const fn new() -> Self {
        Self { seen: 0 }
    }

    fn step(&mut self, sight: &impl Sight, legs: &impl Legs, feet: &Feet) {
        self.seen = sight.distance() + legs.steps() + feet.visits;
    }
}

fn links(graph: &bica_core::Graph, of: usize) -> Vec<(usize, LinkKind, Option<usize>, Roles)> {
    graph.nodes[of].links.iter().map(|link| (link.to, link.kind, link.state, link.roles)).collect()
}

#[test]
fn a_role_links_the_component_that_the_tree_names() {
    let mut tree = Seeing::new();
    assert_eq!(runs(&mut tree, 0), ["Eye", "Feet", "Follow"]);
    assert_eq!(tree.get::<Follow>().seen, 4);
    assert_eq!(runs(&mut tree, 10), ["Eye", "Feet", "Follow"], "the provider of a role that is read, before the state");
    assert_eq!(runs(&mut tree, 20), ["Eye", "Follow", "Feet"], "the provider of a role that is written, after it");
    assert_eq!(tree.get::<Feet>().steps, 4);
}

#[test]
fn the_graph_names_the_roles_of_each_link() {
    let (sight, legs) = (Roles::NONE.with(0), Roles::NONE.with(1));
    let (read, write) = (LinkKind::Requirement, LinkKind::Modulation);
    let expected =
        [(1, read, Some(0), sight), (2, read, Some(0), legs), (1, read, Some(1), sight), (2, write, Some(1), legs)];
    assert_eq!(links(&Seeing::GRAPH, 0), expected);
    assert_eq!(Seeing::GRAPH.roles, ["Sight", "Legs"]);
    let drawn = Seeing::GRAPH.mermaid().to_string();
    assert!(drawn.contains("n0 -.->|\"Sight\"| n1") && drawn.contains("n0 -->|\"Legs · go\"| n2"), "{drawn}");
}

#[test]
fn roles_and_a_name_of_one_component_are_one_link() {
    let mut tree = Feeling::new();
    assert_eq!(links(&Feeling::GRAPH, 0), [(1, LinkKind::Requirement, None, Roles::NONE.with(0).with(1))]);
    for cycle in 0..4 {
        assert_eq!(runs(&mut tree, 10 * cycle), ["Feet", "Watch"], "also in steady ticks");
    }
    assert_eq!(tree.get::<Watch>().seen, 4);
}

#[test]
fn roles_do_not_change_the_hash() {
    let graph = Seeing::GRAPH;
    assert_eq!(bica_core::graph::hash(&bica_core::Graph { roles: &[], ..graph }), Seeing::HASH);
}
