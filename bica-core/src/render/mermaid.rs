//! Mermaid.

use core::fmt::{Display, Formatter, Result, Write, from_fn};

use super::label::{self, Escaped, figures, link, transition};
use super::{Arrow, arrows};
use crate::graph::{Graph, LinkKind, Node, Roles};

pub(super) fn tree(graph: &Graph, f: &mut Formatter<'_>) -> Result {
    f.write_str("flowchart TD\n")?;
    for index in 0..graph.nodes.len() {
        component(f, graph, index)?;
    }
    for (from, node) in graph.nodes.iter().enumerate() {
        arrows(node).try_for_each(|to| arrow(f, graph, from, to))?;
        let mut queries = node.queries.distinct();
        queries.try_for_each(|query| writeln!(f, "  n{from} -.-o|\"{}\"| n{}", query.kind.word(), query.of))?;
    }
    writeln!(f, "  style n{} stroke-width:3px", graph.root)
}

/// A round box, with double sides for a machine.
fn component(f: &mut Formatter<'_>, graph: &Graph, index: usize) -> Result {
    let node = &graph.nodes[index];
    let (open, close) = if node.states.is_empty() { ("(\"", "\")") } else { ("[[\"", "\"]]") };
    writeln!(f, "  n{index}{open}{}<br/>{}{close}", escaped(&node.name), escaped(&figures(graph, index)))
}

fn arrow(f: &mut Formatter<'_>, graph: &Graph, from: usize, arrow: Arrow<'_>) -> Result {
    let line = match arrow.kind() {
        LinkKind::Requirement => "-.->",
        LinkKind::Modulation => "-->",
    };
    if arrow.is_always() && arrow.roles() == Roles::NONE {
        writeln!(f, "  n{from} {line} n{}", arrow.to())
    } else {
        writeln!(f, "  n{from} {line}|\"{}\"| n{}", escaped(&link(graph, arrow)), arrow.to())
    }
}

pub(super) fn machine(node: &Node, f: &mut Formatter<'_>) -> Result {
    f.write_str("stateDiagram-v2\n")?;
    for (index, state) in node.states.iter().enumerate() {
        writeln!(f, "  state \"{}\" as s{index}", escaped(&label::state(node, index)))?;
        if state.initial {
            writeln!(f, "  [*] --> s{index}")?;
        }
        if state.last {
            writeln!(f, "  s{index} --> [*]")?;
        }
    }
    for edge in node.transitions {
        let label = transition(node, edge);
        writeln!(f, "  s{} --> s{}: {}", edge.from, edge.to, escaped(&label))?;
    }
    Ok(())
}

fn escaped(text: &impl Display) -> impl Display {
    from_fn(move |f| write!(Escaped { out: f, escape }, "{text}"))
}

/// Letters and digits stand for themselves; what may mean something to one of the languages inside Mermaid (its own,
/// Markdown, HTML) is written as an entity.
fn escape(f: &mut Formatter<'_>, character: char) -> Result {
    match character {
        ' ' | '_' | ',' | '.' => f.write_char(character),
        control if control.is_control() => f.write_str(" "),
        special if special.is_ascii_punctuation() => write!(f, "#{};", special as u32),
        other => f.write_char(other),
    }
}
