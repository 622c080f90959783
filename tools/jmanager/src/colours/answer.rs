//! The field boundary of an image.

use serde::Serialize;

/// Field boundary in an image and its evidence, px.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Boundary {
    /// The scanned columns, from the left.
    pub(super) columns: Vec<BoundaryColumn>,
    /// Corners of the boundary, from the left; empty if no field is in view.
    pub(super) corners: Vec<(f32, f32)>,
    /// Largest distance of an inlier from the boundary.
    pub(super) inlier_distance: f32,
}

/// A column that was scanned for the field boundary.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct BoundaryColumn {
    /// Column.
    pub(super) x: f32,
    /// Row of the edge of the carpet; none where there is too little green.
    pub(super) y: Option<f32>,
    /// Whether it supports the boundary, or the reason why not.
    pub(super) verdict: BoundaryVerdict,
}

/// Whether a column supports the field boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum BoundaryVerdict {
    /// It lies on the boundary.
    Inlier,
    /// It has too little green.
    NoGreen,
    /// Its edge is above the boundary: green outside the field.
    Above,
    /// Its edge is below the boundary: something covers the edge of the carpet.
    Below,
    /// No boundary was found.
    NoBoundary,
}
