//! Values of visual types on the ground and in space as points and lines.

use std::f64::consts::TAU;

use serde_json::Value;

/// Number of corners of a circle.
const CORNERS: u32 = 24;
/// Distance of the points on a line, m, and maximum number of points on one edge.
const SAMPLE: (f64, f64) = (0.1, 32.0);
/// Length of the arrow that shows a pose, m.
pub const ARROW: f64 = 0.3;

/// Place of a frame in another one: position, m, and rotation, a quaternion `x, y, z, w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position, m.
    pub position: [f64; 3],
    /// Rotation, a unit quaternion `x, y, z, w`.
    pub rotation: [f64; 4],
}

/// Something that is drawn, m.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A point.
    Dot([f64; 3]),
    /// A pose.
    Arrow(Pose),
    /// Points joined by lines; the last one with the first one, if it is closed.
    Line(Vec<[f64; 3]>, bool),
    /// Points.
    Cloud(Vec<[f64; 3]>),
}

/// Rotation from the axes of an image, x right, y down and z ahead, to those of its camera.
pub const OPTICAL: Pose = Pose { position: [0.0; 3], rotation: [-0.5, 0.5, -0.5, 0.5] };
/// Visual type of the parameters of a camera.
pub const CALIBRATION: &str = "CameraCalibration";

/// Returns whether values of a visual type are drawn; those of a robot's own body are numbers.
#[must_use]
pub fn is_drawn(kind: &str) -> bool {
    !matches!(kind, "Joints" | "Imu")
}

/// Calls a function with each value of an output, which may be an option or a list.
pub fn each<'a>(value: &'a Value, take: &mut impl FnMut(&'a Value)) {
    match value {
        Value::Array(values) => values.iter().for_each(|value| each(value, take)),
        Value::Null => {}
        value => take(value),
    }
}

/// Returns numbers with these names; `None` if one is missing or not finite.
#[must_use]
pub fn numbers<const N: usize>(value: &Value, names: [&str; N]) -> Option<[f64; N]> {
    let mut numbers = [0.0; N];
    for (number, name) in numbers.iter_mut().zip(names) {
        *number = value.get(name)?.as_f64()?;
    }
    Some(numbers)
}

/// Returns a point on the ground or in space.
#[must_use]
pub fn point(value: &Value) -> Option<[f64; 3]> {
    let [x, y] = numbers(value, ["x", "y"])?;
    Some([x, y, value.get("z").map_or(Some(0.0), Value::as_f64)?])
}

/// Returns the points of a polyline.
#[must_use]
pub fn points(values: &Value) -> Option<Vec<[f64; 3]>> {
    values.get("points")?.as_array()?.iter().map(point).collect()
}

/// Returns a pose on the ground or in space.
#[must_use]
pub fn pose(value: &Value) -> Option<Pose> {
    if let Some(position) = value.get("position") {
        let rotation = numbers(value.get("orientation")?, ["x", "y", "z", "w"])?;
        return Some(Pose { position: point(position)?, rotation });
    }
    let [heading] = numbers(value, ["heading"])?;
    let (sin, cos) = (0.5 * heading).sin_cos();
    Some(Pose { position: point(value)?, rotation: [0.0, 0.0, sin, cos] })
}

/// Returns the shapes of one value of a visual type; none if it has a number that is not finite.
#[must_use]
pub fn shapes(kind: &str, value: &Value) -> Vec<Shape> {
    of_value(kind, value).unwrap_or_default()
}

fn of_value(kind: &str, value: &Value) -> Option<Vec<Shape>> {
    Some(match kind {
        "Point2" | "Point3" => vec![Shape::Dot(point(value)?)],
        "Pose2" | "Pose3" => vec![Shape::Arrow(pose(value)?)],
        "Segment" => vec![Shape::Line(vec![point(value.get("start")?)?, point(value.get("end")?)?], false)],
        "Polyline" => vec![Shape::Line(points(value)?, false)],
        "Circle" => {
            let [radius] = numbers(value, ["radius"])?;
            vec![ring(point(value)?, [radius, 0.0], [0.0, radius])]
        }
        "Rectangle" => vec![rectangle(numbers(value, ["x", "y", "heading", "length", "width"])?)],
        "PoseWithCovariance2" => {
            let ellipse = of_value("Ellipse", value)?.into_iter().skip(1);
            core::iter::once(Shape::Arrow(pose(value)?)).chain(ellipse).collect()
        }
        "Ellipse" => {
            let [xx, xy, yy] = numbers(value, ["xx", "xy", "yy"])?;
            // The root of the covariance by Cholesky maps the unit circle to the ellipse of one standard deviation.
            let first = xx.max(0.0).sqrt();
            let mixed = if first > 0.0 { xy / first } else { 0.0 };
            let second = (yy - mixed * mixed).max(0.0).sqrt();
            vec![Shape::Dot(point(value)?), ring(point(value)?, [first, mixed], [0.0, second])]
        }
        "Scan" => vec![scan(value)?],
        _ => return None,
    })
}

/// Returns a closed line around a centre with these conjugate half-axes.
fn ring([x, y, z]: [f64; 3], one: [f64; 2], other: [f64; 2]) -> Shape {
    let corner = |number: u32| {
        let (sin, cos) = (TAU * f64::from(number) / f64::from(CORNERS)).sin_cos();
        [x + cos * one[0] + sin * other[0], y + cos * one[1] + sin * other[1], z]
    };
    Shape::Line((0..CORNERS).map(corner).collect(), true)
}

fn rectangle([x, y, heading, length, width]: [f64; 5]) -> Shape {
    let (sin, cos) = heading.sin_cos();
    let corner = |(along, across): (f64, f64)| {
        let (along, across) = (0.5 * along * length, 0.5 * across * width);
        [x + along * cos - across * sin, y + along * sin + across * cos, 0.0]
    };
    Shape::Line([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(corner).to_vec(), true)
}

fn scan(value: &Value) -> Option<Shape> {
    let [begin, step, range_max] = numbers(value, ["angle_min", "angle_increment", "range_max"])?;
    let ends = (0..).zip(value.get("ranges")?.as_array()?).filter_map(|(ray, range)| {
        let range = range.as_f64().filter(|range| *range <= range_max)?;
        let (sin, cos) = (begin + step * f64::from(ray)).sin_cos();
        Some([range * cos, range * sin, 0.0])
    });
    Some(Shape::Cloud(ends.collect()))
}

impl Shape {
    /// Returns points on the shape.
    #[must_use]
    pub fn sampled(&self) -> Vec<[f64; 3]> {
        match self {
            Self::Dot(point) => vec![*point],
            Self::Cloud(points) => points.clone(),
            Self::Arrow(Pose { position, rotation: [x, y, z, w] }) => {
                // The first axis of the pose.
                let ahead = [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)];
                let tip = [0, 1, 2].map(|axis| position[axis] + ARROW * ahead[axis]);
                Self::Line(vec![*position, tip], false).sampled()
            }
            Self::Line(points, is_closed) => {
                let back = points.first().filter(|_| *is_closed);
                let ends = points.iter().skip(1).chain(back);
                let on_edges = points.iter().zip(ends).flat_map(|(from, to)| edge(*from, *to));
                on_edges.chain(points.last().filter(|_| !is_closed).copied()).collect()
            }
        }
    }
}

/// Returns points on a line without its end.
fn edge(from: [f64; 3], to: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let length = [0, 1, 2].map(|axis| (to[axis] - from[axis]).powi(2)).iter().sum::<f64>().sqrt();
    let count = (length / SAMPLE.0).ceil().clamp(1.0, SAMPLE.1);
    (0..count as u32).map(move |number| {
        let share = f64::from(number) / count;
        [0, 1, 2].map(|axis| from[axis] + share * (to[axis] - from[axis]))
    })
}
