//! Covariance of a pose: position in the field frame, m, and heading, rad.
//!
//! The noise of the odometry enlarges it; the sightings of an image reduce it. Their information is the curvature of the logarithm of the
//! likelihood at the pose (Laplace's approximation: Bishop 2006, "Pattern Recognition and Machine Learning", section 4.4).

use core::f32::consts::LN_2;

use bica_motion::pose::Pose2;
use glam::{Mat3, Vec2, Vec3};

use super::likelihood::Observation;

/// Differences of the pose over which the curvature is measured, m and rad: as wide as the likelihood of a close sighting.
const STEP: Vec3 = Vec3::new(0.03, 0.03, 0.02);
/// Standard deviation, m and rad, that each image adds, because the errors of consecutive images are not independent.
const IMAGE_NOISE: Vec3 = Vec3::new(0.000_24, 0.000_24, 0.000_16);

/// Variances, m² and rad², of a pose of which nothing is known, and the largest ones of a covariance.
const UNKNOWN: Vec3 = Vec3::new(25.0, 25.0, 10.0);

/// Covariance of deviations from their mean; zero without deviations.
pub(super) fn of(deviations: impl Iterator<Item = Vec3>) -> Mat3 {
    let (count, sum) = deviations.fold((0.0_f32, Mat3::ZERO), |(count, sum), deviation| {
        let square = Mat3::from_cols(deviation * deviation.x, deviation * deviation.y, deviation * deviation.z);
        (count + 1.0, sum + square)
    });
    sum * (1.0 / count.max(1.0))
}

/// Covariance after a motion over `way`, field frame, m, with these standard deviations of the position in each direction, m, and of
/// the heading, rad: the error of the heading turns the way (Thrun, Burgard, Fox 2005, "Probabilistic Robotics", equation 7.11). That of
/// an unknown pose if a variance would be larger.
pub(super) fn after(before: &Mat3, way: Vec2, position_noise: f32, heading_noise: f32) -> Mat3 {
    let jacobian = Mat3::from_cols(Vec3::X, Vec3::Y, Vec3::new(-way.y, way.x, 1.0));
    let noise = Vec3::new(position_noise, position_noise, heading_noise);
    let after = jacobian * *before * jacobian.transpose() + Mat3::from_diagonal(noise * noise);
    let variances = Vec3::new(after.x_axis.x, after.y_axis.y, after.z_axis.z);
    if variances.cmple(UNKNOWN).all() { after } else { Mat3::from_diagonal(UNKNOWN) }
}

/// Covariance after an image, with the information of its sightings at a pose. Sightings that do not fit have a curvature that is no
/// information: they leave the covariance as it is.
pub(super) fn seen(before: &Mat3, observation: &Observation, pose: &Pose2) -> Mat3 {
    let before = *before + Mat3::from_diagonal(IMAGE_NOISE * IMAGE_NOISE);
    let inverse = before.inverse() + information(observation, pose);
    let (x, y) = (inverse.x_axis, inverse.y_axis);
    let is_positive = x.x > 0.0 && x.x * y.y > x.y * x.y && inverse.determinant() > 0.0;
    if is_positive { inverse.inverse() } else { before }
}

/// Information about the pose in the sightings of an image: the inverse of a covariance.
fn information(observation: &Observation, pose: &Pose2) -> Mat3 {
    let at = |off: Vec3| {
        let off = off * STEP;
        observation.octaves(&Pose2 { position: pose.position + off.truncate(), heading: pose.heading + off.z })
    };
    let centre = 2.0 * at(Vec3::ZERO);
    let curvature = |off: Vec3| centre - at(off) - at(-off);
    let [x, y, turn] = [Vec3::X, Vec3::Y, Vec3::Z].map(curvature);
    let xy = 0.5 * (curvature(Vec3::X + Vec3::Y) - x - y);
    let x_turn = 0.5 * (curvature(Vec3::X + Vec3::Z) - x - turn);
    let y_turn = 0.5 * (curvature(Vec3::Y + Vec3::Z) - y - turn);
    let scale = Mat3::from_diagonal(STEP.recip());
    let curvature = [Vec3::new(x, xy, x_turn), Vec3::new(xy, y, y_turn), Vec3::new(x_turn, y_turn, turn)]
        .map(|column| LN_2 * column);
    scale * Mat3::from_cols(curvature[0], curvature[1], curvature[2]) * scale
}
