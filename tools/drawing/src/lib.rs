//! Drawings for tools: activation trees as SVG and in pictures, with canvas, text and PNG.
//!
//! Coordinates of pictures are pixels: x right, y down.

pub mod canvas;
pub mod layout;
pub mod palette;
pub mod png;
pub mod polar;
mod shapes;
mod svg;
pub mod text;
mod tree_state;
pub mod tree_view;

pub use svg::svg;
pub use tree_state::TreeState;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
