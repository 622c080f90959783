//! Drawings of a state machine.

mod automatic;
mod diagram;
mod notation;
#[cfg(feature = "png")]
mod png;
mod route;
mod svg;

pub use self::automatic::automatic;
pub use self::diagram::{Diagram, Edge, Label, Node};
pub use self::notation::{dot, mermaid};
#[cfg(feature = "png")]
pub use self::png::png;
pub use self::svg::svg;
