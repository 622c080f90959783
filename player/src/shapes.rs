//! Conversions to the types of outputs that tools draw.

use bica::visual::{Ellipse, ImagePoint, Point2, Point3, Pose2, Pose3, PoseWithCovariance2, Quaternion};
use bica_motion::pose;
use bica_vision::memory::PositionEstimate;
use glam::{Affine3A, Mat3, Quat, Vec2, Vec3};

/// Returns a point on the ground.
#[must_use]
pub const fn point(Vec2 { x, y }: Vec2) -> Point2 {
    Point2 { x, y }
}

/// Returns a pose on the ground.
#[must_use]
pub const fn pose(pose::Pose2 { position: Vec2 { x, y }, heading }: pose::Pose2) -> Pose2 {
    Pose2 { x, y, heading }
}

/// Returns a pose with the covariance of its position, m, and heading, rad.
#[must_use]
pub fn pose_with_covariance(pose: pose::Pose2, covariance: &Mat3) -> PoseWithCovariance2 {
    let pose::Pose2 { position: Vec2 { x, y }, heading } = pose;
    let [[xx, xy, xh], [_, yy, yh], [_, _, hh]] = covariance.to_cols_array_2d();
    PoseWithCovariance2 { x, y, heading, xx, xy, xh, yy, yh, hh }
}

/// Returns a position with its covariance.
pub(crate) fn ellipse(PositionEstimate { position: Vec2 { x, y }, covariance }: PositionEstimate) -> Ellipse {
    Ellipse { x, y, xx: covariance.x_axis.x, xy: covariance.x_axis.y, yy: covariance.y_axis.y }
}

/// Returns a pose in space.
pub(crate) fn pose_in_space(pose: &Affine3A) -> Pose3 {
    let Vec3 { x, y, z } = pose.translation.into();
    let turn = Quat::from_mat3a(&pose.matrix3);
    Pose3 { position: Point3 { x, y, z }, orientation: Quaternion { x: turn.x, y: turn.y, z: turn.z, w: turn.w } }
}

/// Returns a vector in space.
pub(crate) const fn vector(Vec3 { x, y, z }: Vec3) -> Point3 {
    Point3 { x, y, z }
}

/// Returns a pixel.
#[must_use]
pub const fn pixel(Vec2 { x, y }: Vec2) -> ImagePoint {
    ImagePoint { x, y }
}
