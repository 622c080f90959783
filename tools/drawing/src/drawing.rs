//! Where a tree is drawn, as data.

use std::fmt::Write as _;

use bica_wire::model::Description;
use serde::Serialize;

use crate::layout::{Kind, Layers, Placement, routes};

/// Largest number of components and of links of a tree from outside; a layout takes a time that grows with their square.
const MAX_COMPONENTS: usize = 256;
const MAX_LINKS: usize = 4 * MAX_COMPONENTS;

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

/// Box of a component; width and height are the same for all.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnBox {
    /// Centre, px.
    pub x: f32,
    /// Upper edge, px.
    pub y: f32,
    /// Kind of the component.
    pub kind: Kind,
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

impl Drawing {
    /// Draws a tree; nothing of one that is too large, or whose links lead nowhere.
    #[must_use]
    pub fn of(tree: &Description) -> Self {
        let (count, links) = (tree.components.len(), tree.components.iter().flat_map(|component| &component.links));
        let is_valid = tree.root < count && count <= MAX_COMPONENTS && links.clone().all(|link| link.to < count);
        if !is_valid || links.count() > MAX_LINKS {
            return Self::default();
        }
        let layers = Layers::new(tree);
        let (placement, routes) = (Placement::new(&layers), routes(tree, &layers));
        let drawn_box = |component: usize| {
            let (x, y) = placement.of(component);
            DrawnBox { x: x as f32, y: y as f32, kind: Kind::of(tree, component) }
        };
        let mut links = Vec::new();
        for (from, node) in tree.components.iter().enumerate() {
            for (link, route) in node.links.iter().zip(&routes[from]) {
                let segments: Vec<_> = route.iter().map(|&index| placement.ends(&layers.segments[index])).collect();
                links.push(DrawnLink { from, to: link.to, path: path(&segments) });
            }
        }
        let (width, height) = (placement.width as f32, placement.height as f32);
        Self { width, height, boxes: (0..count).map(drawn_box).collect(), links }
    }
}

type Point = (f64, f64);

/// Returns the path of a link: a curve for each segment, and a line past the boxes between two segments.
fn path(segments: &[(Point, Point)]) -> String {
    let mut path = String::new();
    for ((x1, y1), (x2, y2)) in segments {
        let (upper, lower) = (y1 + (y2 - y1) * 0.45, y1 + (y2 - y1) * 0.55);
        let start = if path.is_empty() { 'M' } else { 'L' };
        // Writing to a string cannot fail.
        let _ = write!(path, "{start}{x1:.1} {y1:.1}C{x1:.1} {upper:.1} {x2:.1} {lower:.1} {x2:.1} {y2:.1}");
    }
    path
}
