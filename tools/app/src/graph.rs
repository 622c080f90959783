//! `graph`: the activation tree in several formats.

use std::io::{self, Write};

use bica::check::{Choice, Writers, writers};
use bica::graph::{Graph, QueryKind, When};
use bica_drawing::svg;
use bica_recording::Recordable;
use bica_wire::model::Description;
use clap::{Args, ValueEnum};

use crate::console::{Failure, Outcome};

/// Arguments of `graph`.
#[derive(Clone, Debug, Args)]
pub(crate) struct GraphArgs {
    /// Format: a drawing (svg), text for Graphviz (dot) or Markdown (mermaid), or data (json)
    #[arg(long, value_name = "FORMAT", default_value = "svg")]
    format: Format,
    /// Short for --format json
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// Print notes on the tree instead: results for which no transition waits, and children of several writers
    #[arg(long, conflicts_with_all = ["format", "json"])]
    check: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Svg,
    Dot,
    Mermaid,
    Json,
}

/// Prints the tree.
pub(crate) fn run<R: Recordable + Default>(args: &GraphArgs) -> Result<Outcome, Failure> {
    let graph = const { &R::GRAPH };
    if args.check {
        notes(graph).iter().try_for_each(|note| writeln!(io::stdout(), "{note}"))?;
        return Ok(Outcome::Success);
    }
    let text = match if args.json { Format::Json } else { args.format } {
        Format::Svg => svg(&Description::of(graph)),
        Format::Dot => graph.dot().to_string(),
        Format::Mermaid => graph.mermaid().to_string(),
        Format::Json => json(&Description::of(graph).of_robot(&*Box::<R>::default()))?,
    };
    let mut out = io::stdout().lock();
    writeln!(out, "{}", text.trim_end())?;
    out.flush()?;
    Ok(Outcome::Success)
}

/// Returns what the compiler accepts and is probably not meant.
fn notes(graph: &Graph) -> Vec<String> {
    let waits: Vec<When> =
        graph.nodes.iter().flat_map(|node| node.transitions).filter_map(|transition| transition.when).collect();
    let others = graph.nodes.iter().enumerate().filter(|(index, _)| *index != graph.root);
    let ends = others.flat_map(|(index, node)| node.states.iter().map(move |state| (index, node, state)));
    let ends = ends.filter_map(|(index, node, state)| {
        let end =
            state.end.filter(|end| !waits.iter().any(|when| (usize::from(when.child), when.end) == (index, *end)))?;
        let mut queries = graph.nodes.iter().flat_map(|node| node.queries.distinct());
        if queries.any(|query| (query.of, query.kind) == (index, QueryKind::Outcome)) {
            return None;
        }
        let (name, state, word) = (node.name, state.name, end.word());
        Some(format!("no transition waits for `{word}` of `{name}`, with which its state `{state}` ends"))
    });
    ends.chain((0..graph.nodes.len()).filter_map(|child| written(graph, child))).collect()
}

/// Returns who writes a child in one cycle, if several do.
fn written(graph: &Graph, child: usize) -> Option<String> {
    let found = writers(graph, child)?;
    let in_force = graph.nodes[found.in_force()].name;
    let Writers { order, case, .. } = found;
    let names: Vec<String> = order.iter().map(|index| format!("`{}`", graph.nodes[index].name)).collect();
    let of_machine = |index: usize| {
        let (node, what) = (&graph.nodes[index], case.choices[index]);
        let state = match what {
            Choice::State(state) => node.states[state].name,
            Choice::Transition(transition) => node.states[node.transitions[transition].to].name,
            Choice::None | Choice::Any => return None,
        };
        let verb = if matches!(what, Choice::State(_)) { "is in" } else { "enters" };
        Some(format!("`{}` {verb} `{state}`", node.name))
    };
    let machines: Vec<String> = (0..graph.nodes.len()).filter_map(of_machine).collect();
    let when = if machines.is_empty() { "always".to_owned() } else { format!("while {}", machines.join(", ")) };
    let (child, names) = (graph.nodes[child].name, names.join(", then "));
    Some(format!("`{child}` is written in one cycle by {names}, {when}; in force: `{in_force}`"))
}

/// Returns a tree as JSON. It is compiled here, and not once more for each robot.
fn json(description: &Description) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(description)?)
}
