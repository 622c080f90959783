//! Drawings of a state machine.

mod automatic;
mod diagram;
mod notation;
mod parts;
#[cfg(feature = "png")]
mod png;
mod route;
mod svg;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

pub use self::automatic::automatic;
pub use self::diagram::Diagram;
pub use self::notation::{dot, mermaid};
pub use self::parts::{Edge, Label, Node};
#[cfg(feature = "png")]
pub use self::png::png;
pub use self::svg::svg;

/// Format of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Format {
    /// Vector graphics
    Svg,
    /// Picture
    Png,
    /// `stateDiagram-v2` of Mermaid
    Mermaid,
    /// `digraph` of Graphviz
    Dot,
}
