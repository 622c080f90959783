//! Drawings in the formats of Mermaid and Graphviz.

use std::fmt::Write;

use super::parts::{label, titled};
use crate::model::Component;

/// Formats the machine for Mermaid, as a `stateDiagram-v2`.
#[must_use]
pub fn mermaid(component: &Component) -> String {
    let mut out = String::from("stateDiagram-v2\n");
    for state in &component.states {
        let name = &state.function.name.text;
        if let Some(of) = component.takes(name) {
            writeln!(out, "    state \"{}\" as {name}", entities(&titled(name, Some(of)))).unwrap_or_default();
        }
        if state.initial {
            writeln!(out, "    [*] --> {name}").unwrap_or_default();
        }
        if let Some(end) = state.end {
            writeln!(out, "    {name} --> [*] : {end}").unwrap_or_default();
        } else if state.last {
            writeln!(out, "    {name} --> [*]").unwrap_or_default();
        }
    }
    for (from, to, label) in labels(component) {
        writeln!(out, "    {from} --> {to} : {label}").unwrap_or_default();
    }
    out
}

/// Replaces characters that may be syntax of Mermaid by entities.
fn entities(text: &str) -> String {
    let entity = |sign: char| {
        if sign.is_ascii_punctuation() && sign != '_' { format!("#{};", u32::from(sign)) } else { sign.into() }
    };
    text.chars().map(entity).collect()
}

/// Formats the machine for Graphviz, as a `digraph`.
#[must_use]
pub fn dot(component: &Component) -> String {
    let mut out =
        format!("digraph \"{}\" {{\n    rankdir=LR;\n    node [shape=box, style=rounded];\n", component.name.text);
    for state in &component.states {
        let peripheries = if state.last { 2 } else { 1 };
        let width = if state.initial { 2 } else { 1 };
        let name = &state.function.name.text;
        let label =
            component.takes(name).map_or_else(String::new, |of| format!(", label=\"{}\"", titled(name, Some(of))));
        writeln!(out, "    \"{name}\" [peripheries={peripheries}, penwidth={width}{label}];").unwrap_or_default();
    }
    for (from, to, label) in labels(component) {
        writeln!(out, "    \"{from}\" -> \"{to}\" [label=\"{label}\"];").unwrap_or_default();
    }
    out + "}\n"
}

/// Returns the state that is left, the state that is entered, and the label of each transition.
fn labels(component: &Component) -> Vec<(&str, &str, String)> {
    let name = |state: usize| component.states[state].function.name.text.as_str();
    component.machine().edges.iter().map(|edge| (name(edge.from), name(edge.to), label(edge))).collect()
}
