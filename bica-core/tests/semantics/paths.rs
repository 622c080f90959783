//! A component is identified by its type, whatever path names it.

use bica_core::graph::{Link, LinkKind, Roles};

use super::*;

/// Generates components without behaviour.
macro_rules! leaves {
    ($($name:ident),*) => {$(
        pub(crate) struct $name;

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self) {}
        }
    )*};
}

leaves!(Hand, Eye, Ear);

/// Alias of the component `Eye`.
type Camera = Eye;

pub(crate) struct Player;

#[component(crate = bica_core)]
impl Player {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn reach(&mut self, hand: &mut Hand, rate: &mut Rate<Camera>) {}

    #[state]
    fn rest(&mut self, ears: &mut Rate<Ear>) {}

    #[transition(reach -> rest, after_ms = 100)]
    fn held(&self, hand: &super::paths::Hand, eye: &Eye) -> bool {
        true
    }

    #[transition(rest -> reach)]
    fn dropped(&self) -> bool {
        false
    }

    #[entry(rest)]
    fn listen(&mut self, ear: &self::Ear) {}

    #[exit(rest)]
    fn slow_down(&mut self, own: &mut Rate<self::Player>) {}
}

activation_tree! {
    pub(crate) struct ByPaths {
        root: self::Player,
        cycle_hz: 100,
        components: [super::paths::Player, Camera, Hand, self::Ear],
        crate: bica_core,
    }
}

#[test]
fn a_write_by_another_path_outranks_a_read() {
    assert_eq!(runs(&mut ByPaths::new(), 0), ["Camera", "super::paths::Player", "Hand"]);
}

#[test]
fn a_read_outranks_a_rate_by_another_path() {
    let mut tree = ByPaths::new();
    tree.tick(at(0));
    tree.tick(at(100));
    assert_eq!(runs(&mut tree, 110), ["self::Ear", "super::paths::Player"]);
}

#[test]
fn links_are_unique_by_child_and_state() {
    let link = |to, kind, state| Link { to, kind, state: Some(state), roles: Roles::NONE };
    let links =
        [link(1, LinkKind::Requirement, 0), link(2, LinkKind::Modulation, 0), link(3, LinkKind::Requirement, 1)];
    assert_eq!(ByPaths::GRAPH.nodes[0].links, links);
    assert_eq!(ByPaths::GRAPH.root, 0);
}

pub(crate) struct Watcher;

#[component(crate = bica_core)]
impl Watcher {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, eye: &Eye, slower: &mut Rate<Camera>) {}
}

activation_tree! {
    pub(crate) struct Watching {
        root: Watcher,
        cycle_hz: 100,
        components: [Watcher, Eye],
        crate: bica_core,
    }
}

#[test]
fn a_step_can_read_a_child_and_set_its_rate() {
    assert_eq!(runs(&mut Watching::new(), 0), ["Eye", "Watcher"]);
    assert_eq!(
        Watching::GRAPH.nodes[0].links,
        [Link { to: 1, kind: LinkKind::Requirement, state: None, roles: Roles::NONE }]
    );
}
