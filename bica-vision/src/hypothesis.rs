//! Hypotheses in the world, validated by projecting them back into the image.
//!
//! A circle in the image could be a ball that lies on the ground: then its place follows from the pixel and the camera's
//! pose, and from the place how large it is in the image. If it is not seen that large, within what pose and pixels may
//! be off, it is no ball. If it is, its size tells something of its place too. Likewise a post's foot tells where its
//! top would be seen. Cost: 0.1 µs.

use glam::{Vec2, Vec3};
use libm::sqrtf;

use crate::memory::PositionEstimate;
use crate::projection::Camera;
use crate::uncertainty::{self, Covariance, Errors, round, square};

/// How far off a hypothesis may be, in deviations.
const DEVIATIONS: f32 = 3.0;
/// How far off a fitted radius is, as a part of it and in pixels: balls are partly hidden, blurred and shaded.
const RADIUS_ERROR: (f32, f32) = (0.1, 0.5);
/// The part of its height by which a post may seem to end elsewhere, beside the errors: crossbar, shade and blur.
const HEIGHT_ERROR: f32 = 0.2;

/// A circle in the image: centre and radius, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImageCircle {
    /// Where.
    pub centre: Vec2,
    /// How large.
    pub radius: f32,
}

impl ImageCircle {
    /// How far off its radius may be, pixels.
    fn error(self) -> f32 {
        let (part, pixels) = RADIUS_ERROR;
        sqrtf(part * part * self.radius * self.radius + pixels * pixels)
    }

    /// How much larger it is than a ball of `radius` metres that lies on the ground there, in deviations; smaller if
    /// negative. Above the horizon the ball has a negative size. None if a number fails, or the camera is not above
    /// the ball.
    #[must_use]
    pub fn size_error(self, camera: &Camera, radius: f32, errors: &Errors) -> Option<f32> {
        let ray = camera.ray(self.centre);
        let above = camera.pose().translation.z - radius;
        let (stretch, focal) = (ray.length(), camera.intrinsics().focal);
        // Off the axis a sphere looks larger, and longer away from the centre.
        let focal = 0.5 * (focal.x + focal.y) * stretch * sqrtf(stretch);
        // Its distance is above / down, so its size is linear in how far down it is seen, even past the horizon.
        let for_down = focal * radius / above;
        let expected = for_down * -ray.z / stretch;
        let lean = for_down * ray.truncate().length() / stretch * (errors.lean + errors.pixels / focal);
        let height = expected * errors.height / above;
        let deviation = Vec3::new(lean, height, self.error()).length();
        let off = (self.radius - expected) / deviation;
        (above > 0.0 && off.is_finite()).then_some(off)
    }

    /// Where a ball of `radius` metres that is seen so touches the ground, m, and how sure that is: by the pixel, and
    /// where that is little sure by the size. None if no ball on the ground is seen so.
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

/// The place that two tell together.
fn both(first: &PositionEstimate, second: &PositionEstimate) -> Option<PositionEstimate> {
    let weight = (first.covariance + second.covariance).try_inverse()?;
    let gain: Covariance = first.covariance * weight;
    let off = second.position - first.position;
    let step = gain * nalgebra::Vector2::new(off.x, off.y);
    let position = first.position + Vec2::new(step.x, step.y);
    let covariance = first.covariance - gain * first.covariance;
    position.is_finite().then_some(PositionEstimate { position, covariance })
}

/// Whether what stands at a pixel, `height` metres high, ends at another one, within the errors.
#[must_use]
pub fn is_as_high(camera: &Camera, foot: Vec2, top: Vec2, height: f32, errors: &Errors) -> bool {
    let slack = DEVIATIONS * (errors.lean * camera.intrinsics().focal.y + errors.pixels);
    // A camera that leans sees both ends higher or lower.
    let expected = |lean: f32| {
        let place = camera.ground(foot + Vec2::new(0.0, lean), 0.0)?;
        camera.pixel(place.extend(height)).map(|pixel| foot.y - (pixel.y - lean))
    };
    let Some(tallest) = expected(slack) else { return false };
    let shortest = expected(-slack).unwrap_or(0.0);
    let rows = foot.y - top.y;
    ((1.0 - HEIGHT_ERROR) * shortest - errors.pixels..=(1.0 + HEIGHT_ERROR) * tallest + errors.pixels).contains(&rows)
}
