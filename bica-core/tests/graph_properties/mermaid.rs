//! Mermaid of a graph and of its machines, parsed line by line.

use std::collections::BTreeSet;

use bica_core::graph::{Graph, Node};
use proptest::prelude::*;

use crate::graph_properties::drawn;
use crate::graph_properties::generate::{every_character, special_graph};

/// Resolves entities; panics on a character that should be escaped.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, entity)) = rest.split_once('#') {
        plain.push_str(before);
        let (code, after) = entity.split_once(';').expect("an entity has an end");
        plain.push(code.parse::<u32>().ok().and_then(char::from_u32).expect("an entity is a character"));
        rest = after;
    }
    plain.push_str(rest);
    let bare = text.replace(|c: char| c == '#' || c == ';' || c.is_ascii_alphanumeric(), "");
    assert!(bare.chars().all(|c| " _,.".contains(c) || !c.is_ascii()), "not escaped: {text:?}");
    plain
}

/// Parses `n0 -.-> n1`, with `|"label"|` after the arrow if there is a label.
fn arrow(line: &str) -> Option<drawn::Arrow> {
    let (from, rest) = line.trim().split_once(' ')?;
    let (style, rest) = rest.split_once("->")?;
    let (label, to) = match rest.strip_prefix("|\"") {
        Some(labelled) => labelled.rsplit_once("\"| ")?,
        None => ("", rest.trim()),
    };
    let index = |word: &str| word.strip_prefix('n')?.parse().ok();
    Some((index(from)?, index(to)?, style == "-.", plain(label)))
}

/// Parses `n0 -.-o|"age"| n1`.
fn query(line: &str) -> (usize, usize, String) {
    let words: Vec<&str> = line.trim().split(' ').collect();
    let index = |word: &str| word[1..].parse().expect("an index");
    (index(words[0]), index(words[2]), words[1].replace(['-', '.', '|', '"'], "").split_off(1))
}

/// Parses `n0("name<br/>figures")`, or with `[[` and `]]` for a machine.
fn component(line: &str) -> Option<(String, String, bool)> {
    let machine = line.contains("[[\"");
    let (_, text) = line.split_once(if machine { "[[\"" } else { "(\"" })?;
    let (name, figures) = text.strip_suffix(if machine { "\"]]" } else { "\")" })?.split_once("<br/>")?;
    Some((plain(name), plain(figures), machine))
}

fn check_tree(graph: &Graph) {
    let text = graph.mermaid().to_string();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("flowchart TD"));
    let components = lines.by_ref().take(graph.nodes.len()).map(|line| component(line).expect(line));
    let expected = graph.nodes.iter().zip(drawn::names(graph)).enumerate();
    let expected = expected.map(|(index, (node, name))| (name, drawn::figures(graph, index), !node.states.is_empty()));
    assert_eq!(components.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    let drawn = lines.by_ref().take(drawn::arrows(graph).len() + drawn::queries(graph).len());
    let (queries, others): (Vec<_>, Vec<_>) = drawn.partition(|line| line.contains(" -.-o|\""));
    assert_eq!(queries.into_iter().map(query).collect::<BTreeSet<_>>(), drawn::queries(graph));
    let arrows = others.into_iter().map(|line| arrow(line).expect(line));
    assert_eq!(arrows.collect::<BTreeSet<_>>(), drawn::arrows(graph));
    assert_eq!(lines.next(), Some(&*format!("  style n{} stroke-width:3px", graph.root)));
    assert_eq!(lines.next(), None);
}

fn check_machine(node: &Node) {
    let text = node.mermaid().to_string();
    let mut lines = text.lines().peekable();
    assert_eq!(lines.next(), Some("stateDiagram-v2"));
    for (index, (name, initial, last)) in drawn::states(node).into_iter().enumerate() {
        let line = lines.next().expect("a line for each state").strip_prefix("  state \"").expect("a state");
        let (text, end) = line.split_once('"').expect("a name has an end");
        assert_eq!((plain(text), end), (name, &*format!(" as s{index}")));
        assert_eq!(lines.next_if(|line| *line == format!("  [*] --> s{index}")).is_some(), initial);
        assert_eq!(lines.next_if(|line| *line == format!("  s{index} --> [*]")).is_some(), last);
    }
    let ways = lines.map(|line| {
        let (ends, label) = line.trim_start().split_once(": ").expect("a label");
        let (from, to) = ends.split_once(" --> ").expect("two ends");
        let index = |word: &str| word[1..].parse().expect("an index");
        (index(from), index(to), plain(label))
    });
    assert_eq!(ways.collect::<Vec<_>>(), drawn::transitions(node));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn mermaid_shows_the_graph(graph in special_graph(6)) {
        check_tree(&graph);
        graph.nodes.iter().for_each(check_machine);
    }
}

#[test]
fn every_character_is_shown() {
    check_tree(&every_character());
    check_machine(&every_character().nodes[0]);
}
