//! Hypothesis tests against the camera model.
//!
//! A circle in the image may be a ball on the ground. Pixel and camera pose give its position, and the position gives its expected
//! size in the image. If the measured size differs by more than the errors of pose and pixels allow, the hypothesis is rejected. If
//! it is accepted, the size improves the position. Likewise the foot of a post predicts the position of its top. Cost: 0.1 µs.

use glam::{Vec2, Vec3};
use libm::sqrtf;

use crate::memory::PositionEstimate;
use crate::projection::Camera;
use crate::uncertainty::{self, Covariance, Errors, inverse, round, square};

/// Maximum deviation of an accepted hypothesis, in standard deviations.
const DEVIATIONS: f32 = 3.0;
/// Standard deviation of a fitted radius, as a share of it: balls are partly hidden, blurred and shaded.
const RADIUS_ERROR: f32 = 0.1;
/// Constant part of this standard deviation, px.
const RADIUS_ERROR_PIXELS: f32 = 0.5;
/// Tolerance on a post's height beyond the errors, as a share of it: crossbar, shade and blur.
const HEIGHT_ERROR: f32 = 0.2;

/// Circle in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImageCircle {
    /// Centre, px.
    pub centre: Vec2,
    /// Radius, px.
    pub radius: f32,
}

impl ImageCircle {
    /// Standard deviation of the radius, px.
    fn error(self) -> f32 {
        let (part, pixels) = (RADIUS_ERROR, RADIUS_ERROR_PIXELS);
        sqrtf(part * part * self.radius * self.radius + pixels * pixels)
    }

    /// Difference between the measured radius and the expected one of a ball of `radius` metres on the ground at this
    /// pixel, in standard deviations; positive if the circle is larger. Above the horizon the expected radius is
    /// negative. `None` without a finite result, or if the camera is not above the ball.
    #[must_use]
    pub fn size_error(self, camera: &Camera, radius: f32, errors: &Errors) -> Option<f32> {
        let ray = camera.ray(self.centre);
        let above = camera.pose().translation.z - radius;
        let (stretch, focal) = (ray.length(), camera.intrinsics().focal);
        // Off the optical axis a sphere appears larger, and elongated away from the image centre.
        let focal = 0.5 * (focal.x + focal.y) * stretch * sqrtf(stretch);
        // The distance is above / down, so the size is linear in the downward component, even past the horizon.
        let for_down = focal * radius / above;
        let expected = for_down * -ray.z / stretch;
        let lean = for_down * ray.truncate().length() / stretch * (errors.lean + errors.pixels / focal);
        let height = expected * errors.height / above;
        let deviation = Vec3::new(lean, height, self.error()).length();
        let off = (self.radius - expected) / deviation;
        (above > 0.0 && off.is_finite()).then_some(off)
    }

    /// Ground position of a ball of `radius` metres, m, with its covariance: from the pixel and, where that is
    /// uncertain, from the size. `None` if the circle fits no ball on the ground.
    #[must_use]
    pub fn ball(self, camera: &Camera, radius: f32, errors: &Errors) -> Option<PositionEstimate> {
        self.size_error(camera, radius, errors).filter(|off| off.abs() <= DEVIATIONS)?;
        let by_size = self.by_size(camera, radius, errors)?;
        let by_pose = camera.ground(self.centre, radius);
        let covariance = by_pose.and_then(|_| uncertainty::of_ground(camera, self.centre, radius, errors));
        let by_pose = by_pose.zip(covariance).map(|(position, covariance)| PositionEstimate { position, covariance });
        Some(by_pose.and_then(|place| both(&place, &by_size)).unwrap_or(by_size))
    }

    fn by_size(self, camera: &Camera, radius: f32, errors: &Errors) -> Option<PositionEstimate> {
        let at = camera.place_by_radius(self.centre, self.radius, radius)?;
        let way = (at - Vec3::from(camera.pose().translation)).truncate();
        let aside = errors.pan + errors.pixels / camera.intrinsics().focal.x;
        let covariance = square(way * (self.error() / self.radius)) + square(way.perp() * aside) + round(errors.height);
        Some(PositionEstimate { position: at.truncate(), covariance })
    }
}

/// Fused estimate of two independent ones.
fn both(first: &PositionEstimate, second: &PositionEstimate) -> Option<PositionEstimate> {
    let weight = inverse(&(first.covariance + second.covariance))?;
    let gain: Covariance = first.covariance * weight;
    let position = first.position + gain * (second.position - first.position);
    let covariance = first.covariance - gain * first.covariance;
    position.is_finite().then_some(PositionEstimate { position, covariance })
}

/// Whether an object at a foot pixel, `height` metres high, ends at a top pixel, within the errors.
#[must_use]
pub fn is_as_high(camera: &Camera, foot: Vec2, top: Vec2, height: f32, errors: &Errors) -> bool {
    let slack = DEVIATIONS * (errors.lean * camera.intrinsics().focal.y + errors.pixels);
    // An error of the camera's pitch moves both ends up or down.
    let expected = |lean: f32| {
        let place = camera.ground(foot + Vec2::new(0.0, lean), 0.0)?;
        camera.pixel(place.extend(height)).map(|pixel| foot.y - (pixel.y - lean))
    };
    let Some(tallest) = expected(slack) else { return false };
    let shortest = expected(-slack).unwrap_or(0.0);
    let rows = foot.y - top.y;
    ((1.0 - HEIGHT_ERROR) * shortest - errors.pixels..=(1.0 + HEIGHT_ERROR) * tallest + errors.pixels).contains(&rows)
}
