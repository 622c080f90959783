//! Layered layouts (after Sugiyama): boxes in rows, crossing reduction, coordinates, and the courses of links between the rows.

mod courses;
mod kind;
mod lanes;
mod machine;
mod parts;
mod ports;
mod rows;
#[cfg(test)]
mod tests;
mod tree;

use serde::Serialize;

pub use courses::path;
pub use kind::{Kind, kinds, links};
pub use parts::{Arrow, Course, LOOKS, Look, Machine};
pub use tree::{Link, Tree, add_queries};

/// x and y, px: to the right and down.
pub type Point = (f64, f64);

/// A rectangle by its centre and size, px.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Rectangle {
    /// x of the centre.
    pub x: f64,
    /// y of the centre.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}
