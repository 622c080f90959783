//! The description of a tree.

use bica_core::graph::{LinkKind, Node, Transition};

use super::machine::Team;
use super::*;

/// The doc of the block.
#[component(hz = 2.5, budget_us = 40, crate = bica_core)]
impl Documented {
    const fn new() -> Self {
        Self
    }

    /// The doc of the step.
    fn step(&mut self) {}
}

pub(crate) struct Documented;

pub(crate) struct Stepped;

#[component(crate = bica_core)]
impl Stepped {
    const fn new() -> Self {
        Self
    }

    /// The doc of the step,
    /// on two lines.
    fn step(&mut self, child: &Documented, rate: &mut Rate<Documented>) {}
}

activation_tree! {
    /// The doc of the tree.
    pub(crate) struct Docs {
        root: Stepped,
        cycle_hz: 50.5,
        budget_ms: 3,
        components: [Documented, Stepped],
        crate: bica_core,
    }
}

fn node(name: &str) -> &'static Node {
    Team::GRAPH.nodes.iter().find(|node| node.name == name).unwrap()
}

#[test]
fn comments_rates_and_budgets_are_in_the_graph() {
    let graph = Docs::GRAPH;
    assert_eq!(
        (graph.name, graph.doc, graph.cycle_hz, graph.budget_ms),
        ("Docs", "The doc of the tree.", 50.5, Some(3.0))
    );
    let [block, step] = graph.nodes else { panic!("two components") };
    assert_eq!((block.doc, block.hz, block.budget_us), ("The doc of the block.", Some(2.5), Some(40.0)));
    assert_eq!((step.doc, step.hz, step.budget_us), ("The doc of the step,\non two lines.", None, None));
    assert_eq!(step.links.len(), 1, "the rate of a child is not a second link");
    assert_eq!((step.links[0].to, step.links[0].kind), (0, LinkKind::Requirement));
    assert_eq!(graph.root, 1);
}

#[test]
fn links_belong_to_states() {
    let player = node("Player");
    let links: Vec<_> =
        player.links.iter().map(|link| (link.state, Team::GRAPH.nodes[link.to].name, link.kind)).collect();
    let (read, write) = (LinkKind::Requirement, LinkKind::Modulation);
    let expected =
        [(Some(0), "Ball", read), (Some(0), "Search", write), (Some(1), "Ball", write), (Some(2), "Ball", read)];
    assert_eq!(links, expected);
}

#[test]
fn transitions_are_listed_in_the_order_of_evaluation() {
    let ways: Vec<_> =
        node("Player").transitions.iter().map(|way| (way.name, way.from, way.to, way.after_ms)).collect();
    let expected = [
        ("near", 0, 1, None),
        ("near", 2, 1, None),
        ("lost", 1, 0, Some(100)),
        ("tired", 1, 2, Some(300)),
        ("never", 0, 2, None),
        ("never", 1, 2, None),
    ];
    assert_eq!(ways, expected);
    let Transition { doc, .. } = node("Player").transitions[0];
    assert_eq!(&*doc, "");
    assert!(node("Resumer").resume && !node("Player").resume);
    assert!(node("Resumer").states[1].last && node("Resumer").states[0].initial);
}

#[test]
fn generic_components_are_listed_as_written() {
    let names: Vec<_> = super::borrows::Cells::GRAPH.nodes.iter().map(|node| node.name).collect();
    assert_eq!(names, ["Sum<1>", "Cell<0>", "Cell<1>", "Cell<2>", "Cell<3>"]);
}

pub(crate) struct Leg<const SIDE: usize>(f32);

#[component(crate = bica_core)]
impl<const SIDE: usize> Leg<SIDE> {
    const fn new() -> Self {
        Self(0.3)
    }
}

pub(crate) struct Walk;

#[component(crate = bica_core)]
impl Walk {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, left: &mut Leg<0>, right: &mut Leg<1>) {}
}

activation_tree! {
    pub(crate) struct Walker { root: Walk, cycle_hz: 50, components: [Walk, left = Leg<0>, right = Leg<1> = Leg(0.5)], crate: bica_core }
}

#[test]
fn a_tree_names_several_of_a_kind() {
    let named: Vec<_> = Walker::GRAPH.nodes.iter().map(|node| (node.name, node.kind, node.type_name())).collect();
    let expected = [("Walk", None, "Walk"), ("left", Some("Leg<0>"), "Leg<0>"), ("right", Some("Leg<1>"), "Leg<1>")];
    assert_eq!(named, expected);
    let walker = Walker::new();
    assert_eq!((Walker::find("right").ok(), walker.get::<Leg<1>>().0), (Some(Walker::id::<Leg<1>>()), 0.5));
    let refused = Walker::find("Leg<0>").map_err(|refusal| refusal.to_string()).expect_err("the name is another one");
    assert!(refused.contains("left") && refused.contains("right"), "{refused}");
    let drawn = Walker::GRAPH.mermaid().to_string();
    assert!(drawn.contains("left<br/>Leg#60;0#62; · every cycle"), "{drawn}");
}
