//! Shapes as markers.

use serde_json::Value;

use super::super::{Color, Header, Marker, Pose, Quaternion, Vector3};
use super::convert::{point, pose};
use crate::shape::{ARROW as LENGTH, Shape, each, shapes};

/// Types of markers.
const ARROW: i32 = 0;
const SPHERE: i32 = 2;
const LINE_STRIP: i32 = 4;
const POINTS: i32 = 8;
/// Action that removes all markers of a namespace.
const DELETE_ALL: i32 = 3;
/// Diameter of a point and of an arrow, and width of a line, m.
const WIDTH: f64 = 0.05;
const LINE: f64 = 0.02;

/// Returns the markers of an output's values, after a marker that removes the earlier ones.
pub(super) fn markers(header: &Header, namespace: &str, kind: &str, value: &Value, [r, g, b]: [f32; 3]) -> Vec<Marker> {
    let empty = || Marker {
        header: header.clone(),
        ns: namespace.to_owned(),
        pose: Pose { orientation: Quaternion { w: 1.0, ..Quaternion::default() }, ..Pose::default() },
        color: Color { r, g, b, a: 1.0 },
        ..Marker::default()
    };
    let mut all = vec![Marker { action: DELETE_ALL, ..empty() }];
    each(value, &mut |value| {
        for shape in shapes(kind, value) {
            all.push(Marker { id: all.len() as i32, ..marker(shape, empty()) });
        }
    });
    all
}

fn marker(shape: Shape, empty: Marker) -> Marker {
    let scale = |x, y, z| Vector3 { x, y, z };
    match shape {
        Shape::Dot(position) => {
            let pose = Pose { position: point(position), ..empty.pose };
            Marker { r#type: SPHERE, pose, scale: scale(WIDTH, WIDTH, WIDTH), ..empty }
        }
        Shape::Arrow(place) => {
            Marker { r#type: ARROW, pose: pose(&place), scale: scale(LENGTH, WIDTH, WIDTH), ..empty }
        }
        Shape::Line(points, is_closed) => {
            let first = points.first().filter(|_| is_closed).copied();
            let points = points.into_iter().chain(first).map(point).collect();
            Marker { r#type: LINE_STRIP, scale: scale(LINE, 0.0, 0.0), points, ..empty }
        }
        Shape::Cloud(points) => {
            let points = points.into_iter().map(point).collect();
            Marker { r#type: POINTS, scale: scale(LINE, LINE, 0.0), points, ..empty }
        }
    }
}
