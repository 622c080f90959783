//! `player graph`: the activation tree in several formats.

use std::io::{self, Write};

use bica_console::{Failure, Outcome};
use bica_drawing::svg;
use bica_game::GRAPH;

use crate::cli::{Format, GraphArgs};

/// Prints the tree.
pub(crate) fn run(args: &GraphArgs) -> Result<Outcome, Failure> {
    let format = if args.json { Format::Json } else { args.format };
    let text = match format {
        Format::Svg => svg(&GRAPH),
        Format::Dot => GRAPH.dot().to_string(),
        Format::Mermaid => GRAPH.mermaid().to_string(),
        Format::Json => GRAPH.json().to_string(),
    };
    let mut out = io::stdout().lock();
    writeln!(out, "{}", text.trim_end())?;
    out.flush()?;
    Ok(Outcome::Success)
}
