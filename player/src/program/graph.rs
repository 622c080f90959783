//! `player graph`: the tree for people and other tools.

use std::io::{self, Write};

use super::cli::{Format, GraphArgs};
use super::ending::{Ending, Failure};
use super::game::scene::GRAPH;
use super::svg;

/// Prints the tree.
pub(crate) fn run(args: &GraphArgs) -> Result<Ending, Failure> {
    let format = if args.json { Format::Json } else { args.format };
    let text = match format {
        Format::Svg => svg::svg(&GRAPH),
        Format::Dot => GRAPH.dot().to_string(),
        Format::Mermaid => GRAPH.mermaid().to_string(),
        Format::Json => GRAPH.json().to_string(),
    };
    let mut out = io::stdout().lock();
    writeln!(out, "{}", text.trim_end())?;
    out.flush()?;
    Ok(Ending::Reached)
}
