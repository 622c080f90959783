//! Messages of Foxglove.

use serde_json::Value;

use super::preview::Preview;
use super::protobuf::Protobuf;
use super::shape::{ARROW, Pose, Shape, each, numbers};

/// Colours of the outputs, in turn: red, green and blue.
const COLOURS: [[f64; 3]; 6] =
    [[0.9, 0.6, 0.0], [0.3, 0.7, 0.9], [0.0, 0.6, 0.5], [0.95, 0.9, 0.25], [0.8, 0.4, 0.0], [0.8, 0.6, 0.7]];
/// Diameter of a point, and width of the shaft of an arrow, m.
const WIDTH: f64 = 0.05;
/// Width of lines on the screen and in images, px.
const LINE: f64 = 2.0;

/// Number of `FLOAT32` in `PackedElementField.NumericType`.
const FLOAT32: u64 = 7;
/// Numbers of `POINTS` and of `LINE_STRIP` in `PointsAnnotation.Type`.
const POINTS: u64 = 1;
const STRIP: u64 = 3;

/// Returns the colour of an output.
pub(super) fn colour(output: usize) -> [f64; 4] {
    let [red, green, blue] = COLOURS[output % COLOURS.len()];
    [red, green, blue, 1.0]
}

fn write_pose(out: &mut Protobuf, number: u32, pose: &Pose) {
    out.nested(number, |out| _ = out.vector(1, &pose.position).vector(2, &pose.rotation));
}

/// Returns the places of frames, each in another one.
pub(super) fn transforms(time: u64, frames: &[(&str, &str, Pose)]) -> Protobuf {
    let mut message = Protobuf::default();
    for (frame, child, pose) in frames {
        message.nested(1, |out| {
            out.timestamp(1, time).text(2, frame).text(3, child).vector(4, &pose.position).vector(5, &pose.rotation);
        });
    }
    message
}

/// Returns an entity with shapes in a colour: red, green, blue and alpha.
pub(super) fn scene(time: u64, frame: &str, id: &str, colour: &[f64; 4], shapes: &[Shape]) -> Protobuf {
    let mut message = Protobuf::default();
    message.nested(2, |entity| {
        entity.timestamp(1, time).text(2, frame).text(3, id);
        for shape in shapes {
            match shape {
                Shape::Dot(position) => {
                    let pose = Pose { position: *position, rotation: [0.0, 0.0, 0.0, 1.0] };
                    entity.nested(9, |out| {
                        write_pose(out, 1, &pose);
                        out.vector(2, &[WIDTH; 3]).vector(3, colour);
                    });
                }
                Shape::Arrow(pose) => _ = entity.nested(7, |out| write_arrow(out, pose, colour)),
                Shape::Line(points, is_closed) => {
                    entity.nested(11, |out| {
                        out.int(1, (*is_closed).into()).double(3, LINE).int(4, 1);
                        for point in points {
                            out.vector(5, point);
                        }
                        out.vector(6, colour);
                    });
                }
                // They are the topic with points.
                Shape::Cloud(_) => {}
            }
        }
    });
    message
}

fn write_arrow(out: &mut Protobuf, pose: &Pose, colour: &[f64]) {
    write_pose(out, 1, pose);
    out.double(2, ARROW - 2.0 * WIDTH).double(3, 0.5 * WIDTH).double(4, 2.0 * WIDTH).double(5, WIDTH);
    out.vector(6, colour);
}

/// Returns points on shapes.
pub(super) fn points(time: u64, frame: &str, shapes: &[Shape]) -> Protobuf {
    let coordinates = shapes.iter().flat_map(Shape::sampled).flatten();
    let data: Vec<_> = coordinates.flat_map(|value| (value as f32).to_le_bytes()).collect();
    cloud(time, frame, &data)
}

/// Returns points, of three `f32` each.
pub(super) fn cloud(time: u64, frame: &str, data: &[u8]) -> Protobuf {
    let mut message = Protobuf::default();
    message
        .timestamp(1, time)
        .text(2, frame)
        .nested(3, |pose| _ = pose.vector(2, &[0.0, 0.0, 0.0, 1.0]))
        .fixed32(4, 12);
    for (name, offset) in [("x", 0), ("y", 4), ("z", 8)] {
        message.nested(5, |field| _ = field.text(1, name).fixed32(2, offset).int(3, FLOAT32));
    }
    message.bytes(6, data);
    message
}

/// Returns an image.
pub(super) fn image(time: u64, frame: &str, preview: &Preview) -> Protobuf {
    let mut message = Protobuf::default();
    message.timestamp(1, time).bytes(2, &preview.jpeg).text(3, "jpeg").text(4, frame);
    message
}

/// Returns the parameters of the camera of an image; `None` if the value has a number that is not finite.
pub(super) fn calibration(time: u64, frame: &str, value: &Value, preview: &Preview) -> Option<Protobuf> {
    let all = numbers(value, ["focal_x", "focal_y", "centre_x", "centre_y"])?;
    let [fx, fy, cx, cy] = all.map(|number| number * preview.scale);
    let mut message = Protobuf::default();
    message.timestamp(1, time).fixed32(2, preview.width).fixed32(3, preview.height);
    message.doubles(6, &[fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0]);
    message.doubles(7, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    message.doubles(8, &[fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0]).text(9, frame);
    Some(message)
}

/// Returns the values of an output in an image of `scale` of its size.
pub(super) fn annotations(time: u64, kind: &str, output: usize, value: &Value, scale: f64) -> Protobuf {
    let (mut message, colour) = (Protobuf::default(), colour(output));
    let point = |value: &Value| numbers(value, ["x", "y"]).map(|point| point.map(|number| scale * number));
    each(value, &mut |value| {
        if let (Some(centre), Some([radius])) = (point(value), numbers(value, ["radius"])) {
            message.nested(1, |circle| {
                circle.timestamp(1, time).vector(2, &centre).double(3, 2.0 * scale * radius).double(4, LINE);
                circle.vector(6, &colour);
            });
            return;
        }
        let (kind, points) = match kind {
            "ImagePoint" => (POINTS, vec![value]),
            "ImageSegment" => (STRIP, [value.get("start"), value.get("end")].into_iter().flatten().collect()),
            _ => (STRIP, value.get("points").and_then(Value::as_array).into_iter().flatten().collect()),
        };
        if let Some(points) = points.into_iter().map(point).collect::<Option<Vec<_>>>() {
            message.nested(2, |out| {
                out.timestamp(1, time).int(2, kind);
                for point in &points {
                    out.vector(3, point);
                }
                out.vector(4, &colour).double(7, LINE);
            });
        }
    });
    message.timestamp(5, time);
    message
}

/// Returns a line of text. Levels: 1 details, 2 information, 3 warning, 4 error.
pub(super) fn log(time: u64, level: u8, name: &str, text: &str) -> Protobuf {
    let mut message = Protobuf::default();
    message.timestamp(1, time).int(2, level.into()).text(3, text).text(4, name);
    message
}
