//! Graphviz.

use core::fmt::{Display, Formatter, Result, Write, from_fn};

use super::label::{self, Escaped, figures, link, transition};
use super::{Arrow, arrows};
use crate::graph::{Graph, LinkKind, Node};

const STYLE: &str = "  node [shape=box, style=rounded, fontname=\"sans-serif\"];
  edge [fontname=\"sans-serif\", fontsize=10];
";

pub(super) fn tree(graph: &Graph, f: &mut Formatter<'_>) -> Result {
    writeln!(f, "digraph {} {{", quoted(&graph.name))?;
    writeln!(f, "  tooltip={};", quoted(&graph.doc))?;
    f.write_str(STYLE)?;
    for index in 0..graph.nodes.len() {
        component(f, graph, index)?;
    }
    for (from, node) in graph.nodes.iter().enumerate() {
        arrows(node).try_for_each(|to| arrow(f, graph, from, to))?;
        node.queries.distinct().try_for_each(|query| {
            let (to, word) = (query.of, query.kind.word());
            writeln!(f, "  n{from} -> n{to} [style=dotted, arrowhead=odot, constraint=false, label={word}];")
        })?;
    }
    f.write_str("}\n")
}

fn component(f: &mut Formatter<'_>, graph: &Graph, index: usize) -> Result {
    let node = &graph.nodes[index];
    let label = from_fn(|f| write!(f, "{}\n{}", node.name, figures(graph, index)));
    write!(f, "  n{index} [label={}, tooltip={}", quoted(&label), quoted(&node.doc))?;
    f.write_str(if node.states.is_empty() { "" } else { ", peripheries=2" })?;
    f.write_str(if index == graph.root { ", penwidth=2];\n" } else { "];\n" })
}

fn arrow(f: &mut Formatter<'_>, graph: &Graph, from: usize, arrow: Arrow<'_>) -> Result {
    let style = match arrow.kind() {
        LinkKind::Requirement => "dashed",
        LinkKind::Modulation => "solid",
    };
    writeln!(f, "  n{from} -> n{} [style={style}, label={}];", arrow.to(), quoted(&link(graph, arrow)))
}

pub(super) fn machine(node: &Node, f: &mut Formatter<'_>) -> Result {
    writeln!(f, "digraph {} {{", quoted(&node.name))?;
    writeln!(f, "  tooltip={};", quoted(&node.doc))?;
    f.write_str(STYLE)?;
    for (index, state) in node.states.iter().enumerate() {
        write!(f, "  s{index} [label={}, tooltip={}", quoted(&label::state(node, index)), quoted(&state.doc))?;
        f.write_str(if state.last { ", peripheries=2];\n" } else { "];\n" })?;
        if state.initial {
            writeln!(f, "  start [shape=point];\n  start -> s{index};")?;
        }
    }
    for edge in node.transitions {
        let label = transition(node, edge);
        let tooltip = quoted(&edge.doc);
        writeln!(f, "  s{} -> s{} [label={}, tooltip={tooltip}];", edge.from, edge.to, quoted(&label))?;
    }
    f.write_str("}\n")
}

/// A string of the language. It is read twice: for its end, and then for escapes and for entities as in HTML.
fn quoted(text: &impl Display) -> impl Display {
    from_fn(move |f| {
        f.write_str("\"")?;
        write!(Escaped { out: f, escape }, "{text}")?;
        f.write_str("\"")
    })
}

fn escape(f: &mut Formatter<'_>, character: char) -> Result {
    match character {
        '"' => f.write_str("\\\""),
        '\\' => f.write_str("\\\\"),
        '\n' => f.write_str("\\n"),
        '&' => f.write_str("&amp;"),
        control if control.is_control() => f.write_str(" "),
        other => f.write_char(other),
    }
}
