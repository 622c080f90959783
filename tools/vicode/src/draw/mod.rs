//! Drawings of a state machine.

mod automatic;
mod diagram;
mod notation;
mod parts;
#[cfg(feature = "png")]
mod png;
mod route;
mod svg;

pub use self::automatic::automatic;
pub use self::diagram::Diagram;
pub use self::notation::{dot, mermaid};
pub use self::parts::{Edge, Label, Node};
#[cfg(feature = "png")]
pub use self::png::png;
pub use self::svg::svg;
