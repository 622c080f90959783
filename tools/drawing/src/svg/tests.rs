//! The picture of random graphs: complete, nothing on top of another, nothing outside.

use bica::graph::{Graph, Link, LinkKind, Node, State};

use super::svg;
use crate::layout::kind::Kind;
use crate::layout::layers::{Item, Layers};
use crate::layout::place::{BOX_HEIGHT, BOX_WIDTH, Places};

/// Numbers that look random: a linear congruential generator (Knuth's MMIX).
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }
}

fn node(name: &'static str, links: Vec<Link>, states: &'static [State]) -> Node {
    let links = links.leak();
    Node { name, doc: "<&\">\u{1}", hz: None, budget_us: None, resume: false, links, states, transitions: &[] }
}

fn graph(nodes: Vec<Node>) -> Graph {
    Graph { name: "Tree", doc: "", cycle_hz: 100.0, budget_ms: None, root: 0, nodes: nodes.leak() }
}

/// A graph with or without cycles.
fn random(seed: u64, cyclic: bool) -> Graph {
    let mut dice = Dice(seed);
    let count = 1 + dice.below(20);
    let nodes = (0..count).map(|from| {
        let first = if cyclic { 0 } else { from + 1 };
        let links = if first < count { dice.below(5) } else { 0 };
        let mut link = || Link {
            to: first + dice.below(count - first),
            kind: if dice.below(2) == 0 { LinkKind::Requirement } else { LinkKind::Modulation },
            state: None,
        };
        node("A<B> & \"C\"", (0..links).map(|_| link()).collect(), &[])
    });
    graph(nodes.collect())
}

#[test]
fn boxes_keep_apart_and_inside() {
    for seed in 0..200 {
        let layers = Layers::new(&random(seed, seed % 2 == 0));
        let places = Places::new(&layers);
        let boxes: Vec<_> = (0..layers.items.len()).map(|item| (places.of(item), layers.items[item])).collect();
        for (index, &((x, y), item)) in boxes.iter().enumerate() {
            let half = if item == Item::Passage { 0.0 } else { BOX_WIDTH / 2.0 };
            assert!(x - half > 0.0 && x + half < places.width, "seed {seed}");
            assert!(y > 0.0 && y + BOX_HEIGHT < places.height, "seed {seed}");
            for &((other, row), _) in &boxes[index + 1..] {
                assert!((y - row).abs() > BOX_HEIGHT || (x - other).abs() > half, "seed {seed}");
            }
        }
    }
}

#[test]
fn every_link_leads_from_its_activator_to_its_end() {
    for seed in 0..200 {
        let graph = random(seed, seed % 2 == 0);
        let layers = Layers::new(&graph);
        for (from, node) in graph.nodes.iter().enumerate() {
            for link in node.links.iter().filter(|link| link.to != from) {
                let leads = |from: usize, to: usize, upward: bool| {
                    let mut reached = vec![from];
                    while let Some(item) = reached.pop() {
                        let next = layers.segments.iter().filter(|s| s.upper == item && s.upward == upward);
                        for segment in next.filter(|segment| segment.kind == link.kind) {
                            if segment.lower == to {
                                return true;
                            }
                            if layers.items[segment.lower] == Item::Passage {
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
fn drawing_is_complete_and_escaped() {
    for seed in 0..100 {
        let graph = random(seed, seed % 2 == 0);
        let drawn = svg(&graph);
        assert_eq!(drawn.matches(">A&lt;B&gt; &amp; &quot;C&quot;</text>").count(), graph.nodes.len());
        assert_eq!(drawn.matches("<title>&lt;&amp;&quot;&gt; </title>").count(), graph.nodes.len());
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"), "seed {seed}");
        assert_eq!(drawn.matches("<g").count(), drawn.matches("</g>").count());
        assert_eq!(svg(&graph), drawn, "the same picture each time");
    }
}

#[test]
fn kinds_follow_from_links() {
    let link = |to, kind| Link { to, kind, state: None };
    let (read, write) = (LinkKind::Requirement, LinkKind::Modulation);
    let states = &[State { name: "only", doc: "", initial: true, last: true }];
    let graph = graph(vec![
        node("FollowBall", vec![link(1, read), link(2, write), link(4, write)], &[]),
        node("Ball", vec![link(3, read)], &[]),
        node("Motors", vec![], &[]),
        node("CameraInput", vec![], &[]),
        node("Body", vec![link(2, write)], states),
    ]);
    let kinds: Vec<_> = (0..5).map(|node| Kind::of(&graph, node)).collect();
    assert_eq!(kinds, [Kind::Controller, Kind::Perception, Kind::Actuation, Kind::Perception, Kind::Machine]);
}
