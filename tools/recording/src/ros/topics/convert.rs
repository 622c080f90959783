//! Values of visual types as messages.

use serde_json::Value;

use super::super::{
    CameraInfo, Fixed, Header, Imu, JointState, LaserScan, Path, Point, Pose, PoseStamped, PoseWithCovariance,
    PoseWithCovarianceStamped, Quaternion, Transform, TransformStamped, Vector3,
};
use crate::shape::{self, Pose as Place, numbers};

pub(super) const fn point([x, y, z]: [f64; 3]) -> Point {
    Point { x, y, z }
}

const fn vector([x, y, z]: [f64; 3]) -> Vector3 {
    Vector3 { x, y, z }
}

const fn quaternion([x, y, z, w]: [f64; 4]) -> Quaternion {
    Quaternion { x, y, z, w }
}

pub(super) fn pose(place: &Place) -> Pose {
    Pose { position: point(place.position), orientation: quaternion(place.rotation) }
}

/// Returns the place of a frame in the frame of the header.
pub(super) fn transform(header: Header, child_frame_id: String, place: &Place) -> TransformStamped {
    let transform = Transform { translation: vector(place.position), rotation: quaternion(place.rotation) };
    TransformStamped { header, child_frame_id, transform }
}

/// Returns a scan. A ray without a range is infinite, as REP 117 requires.
pub(super) fn scan(header: Header, value: &Value) -> Option<LaserScan> {
    let [angle_min, angle_increment, range_max] =
        numbers(value, ["angle_min", "angle_increment", "range_max"])?.map(|number| number as f32);
    let ranges = value.get("ranges")?.as_array()?.iter();
    let ranges: Vec<_> = ranges.map(|range| range.as_f64().map_or(f32::INFINITY, |range| range as f32)).collect();
    let angle_max = angle_min + angle_increment * ranges.len().saturating_sub(1) as f32;
    Some(LaserScan { header, angle_min, angle_max, angle_increment, range_max, ranges, ..LaserScan::default() })
}

/// Index of the rotation about z in the rows and columns of a covariance.
const YAW: usize = 5;

/// Returns an uncertain position.
pub(super) fn ellipse(header: Header, value: &Value) -> Option<PoseWithCovarianceStamped> {
    let [x, y] = numbers(value, ["x", "y"])?;
    uncertain(header, value, &Place { position: [x, y, 0.0], rotation: [0.0, 0.0, 0.0, 1.0] })
}

/// Returns an uncertain pose on the ground.
pub(super) fn pose_with_covariance(header: Header, value: &Value) -> Option<PoseWithCovarianceStamped> {
    let mut message = uncertain(header, value, &shape::pose(value)?)?;
    let [xh, yh, hh] = numbers(value, ["xh", "yh", "hh"])?;
    for (row, column, entry) in [(0, YAW, xh), (YAW, 0, xh), (1, YAW, yh), (YAW, 1, yh), (YAW, YAW, hh)] {
        message.pose.covariance.0[6 * row + column] = entry;
    }
    Some(message)
}

fn uncertain(header: Header, value: &Value, place: &Place) -> Option<PoseWithCovarianceStamped> {
    let [xx, xy, yy] = numbers(value, ["xx", "xy", "yy"])?;
    let mut covariance = Fixed::default();
    (covariance.0[0], covariance.0[1], covariance.0[6], covariance.0[7]) = (xx, xy, xy, yy);
    Some(PoseWithCovarianceStamped { header, pose: PoseWithCovariance { pose: pose(place), covariance } })
}

pub(super) fn path(header: &Header, value: &Value) -> Option<Path> {
    let stamped = |position| {
        let place = Place { position, rotation: [0.0, 0.0, 0.0, 1.0] };
        PoseStamped { header: header.clone(), pose: pose(&place) }
    };
    Some(Path { header: header.clone(), poses: shape::points(value)?.into_iter().map(stamped).collect() })
}

pub(super) fn joints(header: Header, value: &Value) -> Option<JointState> {
    let list = |name| value.get(name).and_then(Value::as_array);
    let name = list("names")?.iter().map(|name| name.as_str().map(str::to_owned)).collect::<Option<_>>()?;
    let position = list("positions")?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    Some(JointState { header, name, position, ..JointState::default() })
}

/// Returns inertial values. An unknown orientation is marked as REP 145 requires.
pub(super) fn imu(header: Header, value: &Value) -> Option<Imu> {
    let three = |name| shape::point(value.get(name)?).map(vector);
    let (angular_velocity, linear_acceleration) = (three("angular_velocity")?, three("linear_acceleration")?);
    let orientation = value.get("orientation").and_then(|value| numbers(value, ["x", "y", "z", "w"]));
    let mut orientation_covariance = Fixed::default();
    if orientation.is_none() {
        orientation_covariance.0[0] = -1.0;
    }
    let orientation = orientation.map(quaternion).unwrap_or_default();
    Some(Imu { header, orientation, orientation_covariance, angular_velocity, linear_acceleration, ..Imu::default() })
}

/// Returns the parameters of a camera without distortion, for an image that was scaled by `scale`.
pub(super) fn camera(header: Header, value: &Value, [width, height]: [u32; 2], scale: f64) -> Option<CameraInfo> {
    let all = numbers(value, ["focal_x", "focal_y", "centre_x", "centre_y"])?;
    let [fx, fy, cx, cy] = all.map(|number| number * scale);
    let k = Fixed([fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0]);
    let r = Fixed([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let p = Fixed([fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let (distortion_model, d) = ("plumb_bob".to_owned(), vec![0.0; 5]);
    Some(CameraInfo { header, height, width, distortion_model, d, k, r, p, ..CameraInfo::default() })
}
