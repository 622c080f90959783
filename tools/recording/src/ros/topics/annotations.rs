//! Values in an image as annotations.

use serde_json::Value;

use super::super::{CircleAnnotation, ImageAnnotations, ImageColor, ImagePoint, PointsAnnotation, Time};
use crate::shape::{each, numbers};

/// Width of lines, px.
const LINE: f64 = 2.0;
/// Numbers of `POINTS` and of `LINE_STRIP` in `PointsAnnotation`.
const POINTS: u8 = 1;
const STRIP: u8 = 3;

/// Returns the values of an output with the image type `kind`, as annotations of an image that was scaled by `scale`.
pub(super) fn annotations(
    timestamp: Time,
    kind: &str,
    [r, g, b]: [f32; 3],
    value: &Value,
    scale: f64,
) -> ImageAnnotations {
    let outline_color = ImageColor { r: r.into(), g: g.into(), b: b.into(), a: 1.0 };
    let (mut circles, mut lines) = (Vec::new(), Vec::new());
    let point = |value: &Value| numbers(value, ["x", "y"]).map(|[x, y]| ImagePoint { x: scale * x, y: scale * y });
    each(value, &mut |value| {
        if let (Some(position), Some([radius])) = (point(value), numbers(value, ["radius"])) {
            let (diameter, thickness, fill_color) = (2.0 * scale * radius, LINE, ImageColor::default());
            let (timestamp, outline_color, metadata) = (timestamp.clone(), outline_color.clone(), Vec::new());
            circles.push(CircleAnnotation {
                timestamp,
                position,
                diameter,
                thickness,
                fill_color,
                outline_color,
                metadata,
            });
            return;
        }
        let (kind, points) = match kind {
            "ImagePoint" => (POINTS, vec![value]),
            "ImageSegment" => (STRIP, [value.get("start"), value.get("end")].into_iter().flatten().collect()),
            _ => (STRIP, value.get("points").and_then(Value::as_array).into_iter().flatten().collect()),
        };
        if let Some(points) = points.into_iter().map(point).collect() {
            let (timestamp, outline_color) = (timestamp.clone(), outline_color.clone());
            let line =
                PointsAnnotation { timestamp, r#type: kind, points, outline_color, ..PointsAnnotation::default() };
            lines.push(PointsAnnotation { thickness: LINE, ..line });
        }
    });
    ImageAnnotations { timestamp, circles, points: lines, ..ImageAnnotations::default() }
}
