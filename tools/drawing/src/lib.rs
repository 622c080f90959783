//! Drawings for tools: the layout of activation trees and state machines, trees as SVG, and with the feature `pictures` in pictures,
//! with canvas, text and PNG.
//!
//! Coordinates of pictures are pixels: x right, y down.

#[cfg(feature = "pictures")]
pub mod canvas;
pub mod layout;
#[cfg(feature = "pictures")]
pub mod palette;
#[cfg(feature = "pictures")]
pub mod png;
#[cfg(feature = "pictures")]
mod shapes;
mod svg;
#[cfg(feature = "pictures")]
pub mod text;
mod tree_state;
#[cfg(feature = "pictures")]
pub mod tree_view;

pub use svg::svg;
pub use tree_state::TreeState;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
