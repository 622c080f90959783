//! Drawings of random graphs: complete, without overlaps, inside their bounds.

use bica_wire::model::{Component, Description, Link, LinkKind, State};

use super::svg;
use crate::layout::{BOX_HEIGHT, BOX_WIDTH, Item, Kind, Layers, Placement, routes};

/// Linear congruential generator (Knuth's MMIX).
struct Rng(u64);

impl Rng {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }
}

fn node(name: &str, links: Vec<Link>, states: Vec<State>) -> Component {
    Component { name: name.to_owned(), doc: "<&\">\u{1}".to_owned(), links, states, ..Component::default() }
}

fn graph(components: Vec<Component>) -> Description {
    Description { components, ..Description::default() }
}

/// Returns a random graph, with or without cycles.
fn random(seed: u64, cyclic: bool) -> Description {
    let mut rng = Rng(seed);
    let count = 1 + rng.below(20);
    let nodes = (0..count).map(|from| {
        let first = if cyclic { 0 } else { from + 1 };
        let links = if first < count { rng.below(5) } else { 0 };
        let mut link = || Link {
            to: first + rng.below(count - first),
            kind: if rng.below(2) == 0 { LinkKind::Requirement } else { LinkKind::Modulation },
            state: None,
            roles: Vec::new(),
        };
        node("A<B> & \"C\"", (0..links).map(|_| link()).collect(), Vec::new())
    });
    graph(nodes.collect())
}

#[test]
fn boxes_do_not_overlap_and_lie_inside_drawing() {
    for seed in 0..200 {
        let layers = Layers::new(&random(seed, seed % 2 == 0));
        let placement = Placement::new(&layers);
        let boxes: Vec<_> = (0..layers.items.len()).map(|item| (placement.of(item), layers.items[item])).collect();
        for (index, &((x, y), item)) in boxes.iter().enumerate() {
            let half = if item == Item::Dummy { 0.0 } else { BOX_WIDTH / 2.0 };
            assert!(x - half > 0.0 && x + half < placement.width, "seed {seed}");
            assert!(y > 0.0 && y + BOX_HEIGHT < placement.height, "seed {seed}");
            for &((other, row), _) in &boxes[index + 1..] {
                assert!((y - row).abs() > BOX_HEIGHT || (x - other).abs() > half, "seed {seed}");
            }
        }
    }
}

#[test]
fn segments_lead_from_owner_to_target() {
    for seed in 0..200 {
        let graph = random(seed, seed % 2 == 0);
        let layers = Layers::new(&graph);
        for (from, node) in graph.components.iter().enumerate() {
            for link in node.links.iter().filter(|link| link.to != from) {
                let leads = |from: usize, to: usize, upward: bool| {
                    let mut reached = vec![from];
                    while let Some(item) = reached.pop() {
                        let next = layers.segments.iter().filter(|s| s.upper == item && s.upward == upward);
                        for segment in next.filter(|segment| segment.kind == link.kind) {
                            if segment.lower == to {
                                return true;
                            }
                            if layers.items[segment.lower] == Item::Dummy {
                                reached.push(segment.lower);
                            }
                        }
                    }
                    false
                };
                assert!(leads(from, link.to, false) || leads(link.to, from, true), "seed {seed}");
            }
        }
    }
}

#[test]
fn routes_lead_from_owner_to_target() {
    for seed in 0..200 {
        let tree = random(seed, false);
        let layers = Layers::new(&tree);
        for (from, (node, ways)) in tree.components.iter().zip(routes(&tree, &layers)).enumerate() {
            for (link, way) in node.links.iter().zip(ways) {
                let mut at = from;
                for segment in way.iter().map(|&index| layers.segments[index]) {
                    assert_eq!((segment.upper, segment.kind), (at, link.kind), "seed {seed}");
                    at = segment.lower;
                }
                assert_eq!(at, link.to, "seed {seed}");
            }
        }
    }
}

#[test]
fn drawing_names_every_component_and_escapes_text() {
    for seed in 0..100 {
        let graph = random(seed, seed % 2 == 0);
        let drawn = svg(&graph);
        assert_eq!(drawn.matches(">A&lt;B&gt; &amp; &quot;C&quot;</text>").count(), graph.components.len());
        assert_eq!(drawn.matches("<title>&lt;&amp;&quot;&gt; </title>").count(), graph.components.len());
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"), "seed {seed}");
        assert_eq!(drawn.matches("<g").count(), drawn.matches("</g>").count());
        assert_eq!(svg(&graph), drawn, "the same picture each time");
    }
}

#[test]
fn kind_of_component_follows_from_its_links() {
    let link = |to, kind| Link { to, kind, state: None, roles: Vec::new() };
    let (read, write) = (LinkKind::Requirement, LinkKind::Modulation);
    let states =
        vec![State { name: "only".to_owned(), doc: String::new(), initial: true, last: true, end: None, before: None }];
    let graph = graph(vec![
        node("FollowBall", vec![link(1, read), link(2, write), link(4, write)], Vec::new()),
        node("Ball", vec![link(3, read)], Vec::new()),
        node("Motors", vec![], Vec::new()),
        node("CameraInput", vec![], Vec::new()),
        node("Body", vec![link(2, write)], states),
    ]);
    let kinds: Vec<_> = (0..5).map(|node| Kind::of(&graph, node)).collect();
    assert_eq!(kinds, [Kind::Controller, Kind::Perception, Kind::Actuation, Kind::Perception, Kind::Machine]);
}
