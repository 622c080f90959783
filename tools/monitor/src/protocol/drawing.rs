//! The drawing of a tree.

use serde::Serialize;

/// Where a tree is drawn, px.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Drawing {
    /// Width.
    pub width: f32,
    /// Height.
    pub height: f32,
    /// One box for each component.
    pub boxes: Vec<DrawnBox>,
    /// One for each link, in the order of the description: component by component.
    pub links: Vec<DrawnLink>,
}

/// Box of a component: centre x, upper y; width and height are the same for all.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnBox {
    /// Centre, px.
    pub x: f32,
    /// Upper edge, px.
    pub y: f32,
    /// `machine`, `controller`, `perception` or `actuation`.
    pub kind: String,
}

/// A drawn link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnLink {
    /// Activating component.
    pub from: usize,
    /// Activated component.
    pub to: usize,
    /// Path in SVG's notation.
    pub path: String,
}
