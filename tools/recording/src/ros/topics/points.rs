//! Shapes as points: Rerun shows no markers.

use super::super::{Header, PointCloud, PointField};
use crate::shape::Shape;

/// Number of `FLOAT32` in `PointField`.
const FLOAT32: u8 = 7;
/// Bytes of a point.
const STEP: u32 = 12;

/// Returns points on shapes.
pub(super) fn points(header: Header, shapes: &[Shape]) -> PointCloud {
    let coordinates = shapes.iter().flat_map(Shape::sampled).flatten();
    cloud(header, coordinates.flat_map(|value| (value as f32).to_le_bytes()).collect())
}

/// Returns points, of three little-endian `f32` each. Bytes after the last whole point are left out.
pub(super) fn cloud(header: Header, mut data: Vec<u8>) -> PointCloud {
    let field = |(name, offset): (&str, u32)| PointField { name: name.to_owned(), offset, datatype: FLOAT32, count: 1 };
    let fields = [("x", 0), ("y", 4), ("z", 8)].map(field).to_vec();
    let width = data.len() as u32 / STEP;
    let row_step = width * STEP;
    data.truncate(row_step as usize);
    PointCloud {
        header,
        height: 1,
        width,
        fields,
        point_step: STEP,
        row_step,
        data,
        is_dense: true,
        ..PointCloud::default()
    }
}
