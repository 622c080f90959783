//! Random graphs.

use bica_core::graph::{
    Doc, Graph, InForce, Link, LinkKind, Node, Queries, Query, QueryKind, Roles, State, Transition,
};
use proptest::prelude::*;

use crate::graph_properties::build;

/// Component before the number of components is known.
#[derive(Clone, Debug)]
struct Draft {
    budget_us: Option<u32>,
    hz: Option<u32>,
    links: Vec<(prop::sample::Index, bool, Option<prop::sample::Index>)>,
    states: usize,
    writers: Option<InForce>,
    transitions: Vec<(prop::sample::Index, prop::sample::Index)>,
}

fn draft() -> impl Strategy<Value = Draft> {
    let index = any::<prop::sample::Index>;
    (
        prop::option::of(0..5000_u32),
        prop::option::of(1..=100_u32),
        prop::collection::vec((index(), any::<bool>(), prop::option::weighted(0.8, index())), 0..6),
        prop_oneof![1 => Just(0_usize), 2 => 1..4_usize],
        prop_oneof![Just(None), Just(Some(InForce::First)), Just(Some(InForce::Last))],
        prop::collection::vec((index(), index()), 0..5),
    )
        .prop_map(|(budget_us, hz, links, states, writers, transitions)| Draft {
            budget_us,
            hz,
            links,
            states,
            writers,
            transitions,
        })
}

/// Graphs of up to `max` components with links in all directions.
pub(crate) fn any_graph(max: usize) -> impl Strategy<Value = Graph> {
    (prop::collection::vec(draft(), 1..=max), any::<prop::sample::Index>())
        .prop_map(|(drafts, root)| graph(&drafts, root.index(drafts.len()), |_, to| Some(to.index(drafts.len()))))
}

/// Graphs of up to `max` components without a cycle, listed in a random order.
pub(crate) fn acyclic_graph(max: usize) -> impl Strategy<Value = Graph> {
    prop::collection::vec(draft(), 1..=max)
        .prop_flat_map(|drafts| {
            let places: Vec<usize> = (0..drafts.len()).collect();
            (Just(drafts), Just(places).prop_shuffle())
        })
        .prop_map(|(drafts, node_at)| {
            let mut place_of = vec![0; drafts.len()];
            node_at.iter().enumerate().for_each(|(place, &node)| place_of[node] = place);
            graph(&drafts, node_at[0], |from, to| {
                let behind = &node_at[place_of[from] + 1..];
                (!behind.is_empty()).then(|| behind[to.index(behind.len())])
            })
        })
}

fn graph(drafts: &[Draft], root: usize, to: impl Fn(usize, &prop::sample::Index) -> Option<usize>) -> Graph {
    let nodes = drafts.iter().enumerate().map(|(from, draft)| node(draft, |link| to(from, link))).collect::<Vec<_>>();
    Graph { root, ..build::graph(nodes.leak()) }
}

fn node(draft: &Draft, to: impl Fn(&prop::sample::Index) -> Option<usize>) -> Node {
    let state = |index: &prop::sample::Index| (draft.states > 0).then(|| index.index(draft.states));
    let links = draft.links.iter().filter_map(|(end, read, of)| {
        let kind = if *read { LinkKind::Requirement } else { LinkKind::Modulation };
        let role = |bit: usize| (end.index(4) >> bit) % 2 == 1;
        let roles = (0..2).filter(|bit| role(*bit)).fold(Roles::NONE, Roles::with);
        Some(Link { to: to(end)?, kind, state: of.as_ref().and_then(state), roles })
    });
    let states = (0..draft.states).map(|index| State { initial: index == 0, ..build::state("state") });
    let ways = draft.transitions.iter().filter_map(|(from, to)| Some(build::transition(state(from)?, state(to)?)));
    Node {
        budget_us: draft.budget_us.map(|budget| budget as f32),
        hz: draft.hz.map(|hz| hz as f32),
        writers: draft.writers,
        links: links.collect::<Vec<_>>().leak(),
        states: states.collect::<Vec<_>>().leak(),
        transitions: ways.collect::<Vec<Transition>>().leak(),
        ..build::node("Node")
    }
}

/// Text that needs escaping.
fn special_text() -> impl Strategy<Value = &'static str> {
    prop_oneof!["(?s).{0,8}", "[\"\\\\&#<>;:|`{}\n\r\t\0 -]{0,6}", "[a-z_]{1,9}"].prop_map(|text| &*text.leak())
}

/// Machine whose names and docs contain every character below U+0300.
pub(crate) fn every_character() -> Graph {
    let text = &*(0..0x300_u32).filter_map(char::from_u32).collect::<String>().leak();
    let node = Node {
        doc: text,
        links: &[Link { to: 1, kind: LinkKind::Requirement, state: Some(0), roles: Roles::NONE }],
        states: vec![State { doc: text, initial: true, ..build::state(text) }, build::state("other")].leak(),
        transitions: vec![Transition { name: text, doc: Doc::new(text), ..build::transition(0, 1) }].leak(),
        ..build::node(text)
    };
    Graph { name: text, doc: text, ..build::graph(vec![node, build::node("Other")].leak()) }
}

/// Graphs with arbitrary names, docs and numbers.
pub(crate) fn special_graph(max: usize) -> impl Strategy<Value = Graph> {
    let texts = prop::collection::vec(special_text(), 16);
    let figures = prop::collection::vec(any::<f32>(), 8);
    (any_graph(max), texts, figures, any::<u32>()).prop_map(|(graph, texts, figures, after_ms)| {
        let mut text = texts.into_iter().cycle();
        let mut text = move || text.next().unwrap_or_default();
        let mut figure = figures.into_iter().cycle();
        let mut nodes = graph.nodes.to_vec();
        let count = nodes.len();
        for (index, node) in nodes.iter_mut().enumerate() {
            let place = after_ms as usize + index;
            let query = Query { of: place % count, kind: [QueryKind::Age, QueryKind::Outcome][place / 8 % 2] };
            node.queries = Queries::new(&*vec![query; place % 3].leak());
            (node.name, node.doc, node.resume) = (text(), text(), text().is_empty());
            node.hz = node.hz.and_then(|_| figure.next());
            node.budget_us = node.budget_us.and_then(|_| figure.next());
            let mut states = node.states.to_vec();
            for state in &mut states {
                (state.name, state.doc, state.last) = (text(), text(), text().is_empty());
            }
            let mut ways = node.transitions.to_vec();
            for transition in &mut ways {
                (transition.name, transition.doc) = (text(), Doc::new(text()));
                transition.after_ms = (!text().is_empty()).then_some(after_ms);
            }
            (node.states, node.transitions) = (states.leak(), ways.leak());
        }
        let budget_ms = figure.next().filter(|_| after_ms % 2 == 0);
        let tunable = after_ms % 3 == 0;
        Graph {
            name: text(),
            doc: text(),
            budget_ms,
            tunable,
            nodes: nodes.leak(),
            roles: vec![text(), text()].leak(),
            ..graph
        }
    })
}
