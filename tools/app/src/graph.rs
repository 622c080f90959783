//! `graph`: the activation tree in several formats.

use std::io::{self, Write};

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

/// Returns a tree as JSON. It is compiled here, and not once more for each robot.
fn json(description: &Description) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(description)?)
}
