//! Prediction of visibility.

use glam::{Vec2, Vec3};

use super::PositionEstimate;
use crate::own_body::OwnBody;
use crate::projection::Camera;
use crate::uncertainty;

/// Radius of the tested confidence region, in standard deviations.
const DEVIATIONS: f32 = 2.0;

/// Whether an image of `size` px shows an object anywhere in the confidence region of its position. The object is a
/// ball, or another object of `radius` metres with its centre at that height.
///
/// False if the object may be outside the image, behind the robot's own body, or farther than `far` metres from the
/// camera. Occlusion by other objects is not considered.
#[must_use]
pub fn is_in_view(camera: &Camera, size: Vec2, own: &OwnBody, place: &PositionEstimate, radius: f32, far: f32) -> bool {
    let spread = DEVIATIONS * uncertainty::largest(&place.covariance);
    let eye = Vec3::from(camera.pose().translation);
    [Vec2::ZERO, Vec2::X, Vec2::NEG_X, Vec2::Y, Vec2::NEG_Y].into_iter().all(|way| {
        let at = (place.position + spread * way).extend(radius);
        let seen = camera.pixel(at).zip(camera.sphere_radius(at, radius));
        let inside = |(pixel, radius): (Vec2, f32)| {
            pixel.min(size - Vec2::ONE - pixel).min_element() >= radius && !own.touches(pixel, radius)
        };
        at.distance(eye) <= far && seen.is_some_and(inside)
    })
}
