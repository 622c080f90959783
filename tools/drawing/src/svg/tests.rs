//! Drawings of random graphs: complete, without overlaps, inside their bounds.

use bica_wire::model::{Component, Description, Link, LinkKind, Query, QueryKind, State, Writer};

use super::{laid_out, queries, svg};
use crate::layout::{Kind, Rectangle};

/// Linear congruential generator (Knuth's MMIX).
pub(crate) struct Rng(pub(crate) u64);

impl Rng {
    pub(crate) fn below(&mut self, end: usize) -> usize {
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

/// Whether a rectangle, made smaller by a distance, and the one between two points have a common area.
fn covers(one: &Rectangle, (a, b): ((f64, f64), (f64, f64)), inset: f64) -> bool {
    let (width, height) = (one.width / 2.0 - inset, one.height / 2.0 - inset);
    a.0.min(b.0) < one.x + width
        && a.0.max(b.0) > one.x - width
        && a.1.min(b.1) < one.y + height
        && a.1.max(b.1) > one.y - height
}

fn corners(one: &Rectangle) -> ((f64, f64), (f64, f64)) {
    let half = (one.width / 2.0, one.height / 2.0);
    ((one.x - half.0, one.y - half.1), (one.x + half.0, one.y + half.1))
}

#[test]
fn boxes_do_not_overlap_and_lie_inside_drawing() {
    for seed in 0..200 {
        let drawn = laid_out(&random(seed, seed % 2 == 0));
        for (index, one) in drawn.boxes.iter().enumerate() {
            let (from, to) = corners(one);
            assert!(from.0 > 0.0 && to.0 < drawn.width && from.1 > 0.0 && to.1 < drawn.height, "seed {seed}");
            let others = &drawn.boxes[index + 1..];
            assert!(others.iter().all(|other| !covers(other, (from, to), 0.0)), "seed {seed}");
        }
    }
}

#[test]
fn lines_lead_around_boxes_from_owner_to_target() {
    for seed in 0..200 {
        let graph = random(seed, seed % 2 == 0);
        let drawn = laid_out(&graph);
        let components = graph.components.iter().enumerate();
        let links = components.flat_map(|(from, one)| one.links.iter().map(move |link| (from, link.to)));
        for ((from, to), line) in links.zip(&drawn.lines) {
            let [from, to] = [from, to].map(|index| &drawn.boxes[index]);
            let (upper, lower) = if from.y < to.y { (from, to) } else { (to, from) };
            if upper.y < lower.y {
                let (first, last) = (line[0], line[line.len() - 1]);
                assert!(covers(upper, (first, first), -1.0) && covers(lower, (last, last), -1.0), "seed {seed}");
            }
            for pair in line.windows(2) {
                let crossed = drawn.boxes.iter().any(|one| covers(one, (pair[0], pair[1]), 0.5));
                assert!(!crossed, "seed {seed}: {line:?}");
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
fn queries_are_drawn_and_no_link_leads_upward() {
    for seed in 0..100 {
        let mut graph = random(seed, false);
        let count = graph.components.len();
        for (from, component) in graph.components.iter_mut().enumerate() {
            let of = (3 * from + seed as usize) % count;
            component.queries.extend((of != from).then_some(Query { of, kind: QueryKind::Age }));
        }
        let last = count - 1;
        graph.components[last].writers = [0, last].map(|by| Writer { by, in_force: by == 0 }).to_vec();
        let (all, drawn) = (queries(&graph).count(), laid_out(&graph));
        assert_eq!(svg(&graph).matches("<title>age</title>").count(), all, "seed {seed}");
        assert_eq!(svg(&graph).matches("asks for an age or outcome").count(), usize::from(all > 0));
        assert!(svg(&graph).contains("every cycle · 2 writers"), "seed {seed}");
        assert!(drawn.lines.iter().all(|line| line.len() > 1), "seed {seed}: each line has two ends");
        for (from, link) in
            graph.components.iter().enumerate().flat_map(|(from, one)| one.links.iter().map(move |to| (from, to)))
        {
            assert!(drawn.boxes[from].y < drawn.boxes[link.to].y, "seed {seed}: {from} to {}", link.to);
        }
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
