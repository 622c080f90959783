//! Text formats of other programs.

use std::fmt::Write;

use crate::model::{Component, Graph};

/// The machine in the language of Mermaid, a `stateDiagram-v2`.
#[must_use]
pub fn mermaid(component: &Component) -> String {
    let mut out = String::from("stateDiagram-v2\n");
    for state in &component.states {
        let name = &state.function.name.text;
        if state.initial {
            writeln!(out, "    [*] --> {name}").unwrap_or_default();
        }
        if state.last {
            writeln!(out, "    {name} --> [*]").unwrap_or_default();
        }
    }
    for (from, to, label) in labels(component) {
        writeln!(out, "    {from} --> {to} : {label}").unwrap_or_default();
    }
    out
}

/// The machine in the language of Graphviz, a `digraph`.
#[must_use]
pub fn dot(component: &Component) -> String {
    let mut out =
        format!("digraph \"{}\" {{\n    rankdir=LR;\n    node [shape=box, style=rounded];\n", component.name.text);
    for state in &component.states {
        let peripheries = if state.last { 2 } else { 1 };
        let width = if state.initial { 2 } else { 1 };
        let name = &state.function.name.text;
        writeln!(out, "    \"{name}\" [peripheries={peripheries}, penwidth={width}];").unwrap_or_default();
    }
    for (from, to, label) in labels(component) {
        writeln!(out, "    \"{from}\" -> \"{to}\" [label=\"{label}\"];").unwrap_or_default();
    }
    out + "}\n"
}

/// From, to and label of each transition.
fn labels(component: &Component) -> Vec<(&str, &str, String)> {
    let name = |state: usize| component.states[state].function.name.text.as_str();
    let timer = |after: Option<u32>| after.map_or_else(String::new, |ms| format!(" after {ms} ms"));
    let edges = Graph::of(component).edges;
    edges.into_iter().map(|edge| (name(edge.from), name(edge.to), edge.name + &timer(edge.after_ms))).collect()
}
