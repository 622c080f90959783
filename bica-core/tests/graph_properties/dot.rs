//! DOT of a graph and of its machines, parsed by the rules of Graphviz's lexer.

use std::collections::{BTreeMap, BTreeSet};

use bica_core::graph::{Graph, Node};
use proptest::prelude::*;

use crate::graph_properties::drawn;
use crate::graph_properties::generate::{every_character, special_graph};

type Attributes = BTreeMap<String, String>;

/// Statement: the words before the brackets, and the attributes in them.
type Statement = (Vec<String>, Attributes);

/// Returns the words of the language; a string is unescaped like a label and keeps its opening quote.
fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let end = match first {
            '"' => string(rest),
            '[' | ']' | '{' | '}' | '=' | ';' | ',' => 1,
            _ => rest.find(|c: char| c.is_whitespace() || "[]{}=;,\"".contains(c)).expect("a statement has an end"),
        };
        words.push(if first == '"' { label(&rest[..end - 1]) } else { rest[..end].into() });
        rest = rest[end..].trim_start();
    }
    words
}

/// Returns the length of the string that starts here. A backslash also consumes the next character.
fn string(text: &str) -> usize {
    let mut bytes = text.bytes().enumerate().skip(1);
    loop {
        match bytes.next().expect("a string has an end") {
            (_, b'\\') => drop(bytes.next()),
            (end, b'"') => return end + 1,
            _ => {}
        }
    }
}

fn label(text: &str) -> String {
    let mut label = String::new();
    let mut characters = text.chars();
    while let Some(character) = characters.next() {
        label.push(match character {
            '\\' => match characters.next().expect("an escape sequence is complete") {
                'n' => '\n',
                plain @ ('\\' | '"') => plain,
                other => panic!("unknown escape {other:?}"),
            },
            plain => plain,
        });
    }
    label.replace("&amp;", "&")
}

fn statements(text: &str) -> Vec<Statement> {
    let words = words(text);
    assert_eq!((words[0].as_str(), words[2].as_str(), words.last().map(String::as_str)), ("digraph", "{", Some("}")));
    words[3..words.len() - 1].split(|word| word == ";").map(statement).collect()
}

fn statement(words: &[String]) -> Statement {
    let Some(open) = words.iter().position(|word| word == "[") else {
        return (words.to_vec(), Attributes::new());
    };
    assert_eq!(words.last().map(String::as_str), Some("]"));
    let attributes = words[open + 1..words.len() - 1]
        .chunks(4)
        .map(|chunk| (chunk[0].clone(), chunk[2].strip_prefix('"').unwrap_or(&chunk[2]).into()));
    (words[..open].to_vec(), attributes.collect())
}

fn index(word: &str) -> usize {
    word[1..].parse().expect("a letter and an index")
}

fn of_edges(statements: &[Statement]) -> impl Iterator<Item = (usize, usize, &Attributes)> {
    let edges = statements.iter().filter(|(words, _)| words.len() == 3 && words[1] == "->" && words[0] != "start");
    edges.map(|(words, attributes)| (index(&words[0]), index(&words[2]), attributes))
}

fn of_boxes<'a>(statements: &'a [Statement], letter: &str) -> Vec<&'a Attributes> {
    let boxes = statements.iter().filter(|(words, _)| {
        words.len() == 1 && words[0].strip_prefix(letter).is_some_and(|index| index.parse::<usize>().is_ok())
    });
    boxes.map(|(_, attributes)| attributes).collect()
}

fn check_tree(graph: &Graph) {
    let statements = statements(&graph.dot().to_string());
    let boxes = of_boxes(&statements, "n");
    let labels: Vec<_> = boxes.iter().map(|attributes| attributes["label"].clone()).collect();
    let expected = drawn::names(graph).into_iter().enumerate();
    let expected: Vec<_> = expected.map(|(index, name)| name + "\n" + &drawn::figures(graph, index)).collect();
    let unbroken = |labels: Vec<String>| labels.into_iter().map(|label| label.replace('\n', " ")).collect::<Vec<_>>();
    assert_eq!(unbroken(labels), unbroken(expected));
    for (index, attributes) in boxes.iter().enumerate() {
        assert_eq!(attributes.contains_key("penwidth"), index == graph.root);
        assert_eq!(attributes.contains_key("peripheries"), !graph.nodes[index].states.is_empty());
    }
    let (dotted, others): (Vec<_>, Vec<_>) = of_edges(&statements).partition(|(.., a)| a["style"] == "dotted");
    let queries: Vec<_> = dotted.into_iter().map(|(from, to, a)| (from, to, a["label"].clone())).collect();
    assert_eq!(queries.len(), drawn::queries(graph).len(), "each query once");
    assert_eq!(queries.into_iter().collect::<BTreeSet<_>>(), drawn::queries(graph));
    let arrows: Vec<_> = others
        .into_iter()
        .map(|(from, to, a)| (from, to, a["style"] == "dashed", a["label"].replace('\n', " ")))
        .collect();
    assert_eq!(arrows.len(), drawn::arrows(graph).len(), "each arrow once");
    assert_eq!(arrows.into_iter().collect::<BTreeSet<_>>(), drawn::arrows(graph));
}

fn check_machine(node: &Node) {
    let statements = statements(&node.dot().to_string());
    let starts = statements.iter().filter(|(words, _)| words.first().is_some_and(|word| word == "start"));
    let starts: Vec<_> = starts.filter(|(words, _)| words.len() == 3).map(|(words, _)| index(&words[2])).collect();
    let boxes = of_boxes(&statements, "s")
        .into_iter()
        .enumerate()
        .map(|(index, a)| (a["label"].replace('\n', " "), starts.contains(&index), a.contains_key("peripheries")));
    assert_eq!(boxes.collect::<Vec<_>>(), drawn::states(node));
    let ways = of_edges(&statements).map(|(from, to, a)| (from, to, a["label"].replace('\n', " ")));
    assert_eq!(ways.collect::<Vec<_>>(), drawn::transitions(node));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn dot_shows_the_graph(graph in special_graph(6)) {
        check_tree(&graph);
        graph.nodes.iter().for_each(check_machine);
    }
}

#[test]
fn every_character_is_shown() {
    check_tree(&every_character());
    check_machine(&every_character().nodes[0]);
}
