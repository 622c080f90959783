//! The pinhole camera model.
//!
//! Camera frame: x along the optical axis, y to the left, z up in the image. Pixels: u to the right, v down, the centre of the
//! first pixel at (0, 0), the principal point at half the width and half the height.

use glam::{Affine3A, Vec2, Vec3};

use crate::spectator::FIELD_OF_VIEW;

/// Distance of the near clipping plane, m.
pub(crate) const NEAR: f32 = 0.01;

/// Focal lengths in unit tests, relative to width and height of the image.
#[cfg(test)]
pub(crate) const FOCAL: Vec2 = bica_motion::model::NAO.dimensions.top_camera.focal;

/// Pose and intrinsic parameters of a camera.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PinholeCamera {
    /// Camera frame in the field frame.
    pub(crate) pose: Affine3A,
    to_camera: Affine3A,
    pub(crate) focal: Vec2,
    centre: Vec2,
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl PinholeCamera {
    /// Returns a camera with these focal lengths relative to the width and the height of the image.
    pub(crate) fn new(pose: Affine3A, focal: Vec2, width: usize, height: usize) -> Self {
        let size = Vec2::new(width as f32, height as f32);
        let focal = size * focal;
        Self { pose, to_camera: pose.inverse(), focal, centre: size / 2.0, width, height }
    }

    /// Returns a camera with square pixels and the vertical field of view [`FIELD_OF_VIEW`].
    pub(crate) fn of_spectator(pose: Affine3A, width: usize, height: usize) -> Self {
        let focal = Vec2::splat(height as f32 / 2.0 / libm::tanf(FIELD_OF_VIEW / 2.0));
        Self { focal, ..Self::new(pose, Vec2::ONE, width, height) }
    }

    /// Transforms a point from the field frame to the camera frame.
    pub(crate) fn in_camera(&self, point: Vec3) -> Vec3 {
        self.to_camera.transform_point3(point)
    }

    /// Projects a point in the camera frame, with x > 0, to the image.
    pub(crate) fn pixel(&self, point: Vec3) -> Vec2 {
        self.centre - self.focal * Vec2::new(point.y, point.z) / point.x
    }

    /// Returns the direction of a pixel's ray in the camera frame, with x = 1.
    pub(crate) fn ray(&self, u: f32, v: f32) -> Vec3 {
        let offset = (self.centre - Vec2::new(u, v)) / self.focal;
        Vec3::new(1.0, offset.x, offset.y)
    }

    /// Returns false only if a sphere in the camera frame lies outside the image.
    pub(crate) fn may_contain(&self, centre: Vec3, radius: f32) -> bool {
        let half = self.centre / self.focal;
        let inside = |across: f32, tan: f32| across.abs() - centre.x * tan <= radius * (1.0 + tan);
        centre.x > NEAR - radius && inside(centre.y, half.x) && inside(centre.z, half.y)
    }

    /// Projects a planar polygon from the field frame to the image, clipped at the near plane; may be empty.
    pub(crate) fn polygon(&self, corners: impl IntoIterator<Item = Vec3>) -> Vec<Vec2> {
        let corners: Vec<Vec3> = corners.into_iter().map(|corner| self.in_camera(corner)).collect();
        Self::clip(&corners).into_iter().map(|corner| self.pixel(corner)).collect()
    }

    /// Clips a polygon in the camera frame at the near plane (Sutherland and Hodgman 1974).
    fn clip(corners: &[Vec3]) -> Vec<Vec3> {
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            if a.x >= NEAR {
                kept.push(a);
            }
            if (a.x >= NEAR) != (b.x >= NEAR) {
                kept.push(a.lerp(b, (NEAR - a.x) / (b.x - a.x)));
            }
        }
        kept
    }

    /// Returns the homography from pixels to a plane in the field frame, given by origin and two perpendicular unit vectors.
    pub(crate) fn mapping(&self, origin: Vec3, along: Vec3, up: Vec3) -> Mapping {
        let normal = along.cross(up);
        let camera = Vec3::from(self.pose.translation) - origin;
        let height = -normal.dot(camera);
        let in_field = |direction: Vec3| self.pose.transform_vector3(direction);
        let first = in_field(self.ray(0.0, 0.0));
        let right = in_field(Vec3::new(0.0, -1.0 / self.focal.x, 0.0));
        let down = in_field(Vec3::new(0.0, 0.0, -1.0 / self.focal.y));
        let row = |axis: Vec3| Vec3::new(axis.dot(first), axis.dot(right), axis.dot(down));
        Mapping {
            along: row(along.dot(camera) * normal + height * along),
            up: row(up.dot(camera) * normal + height * up),
            depth: row(normal),
        }
    }
}

/// Homography from pixels to coordinates in a plane: quotients of linear functions of 1, u and v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mapping {
    along: Vec3,
    up: Vec3,
    depth: Vec3,
}

/// Number of pixels mapped at once.
pub(crate) const LANES: usize = 32;

/// Rounds to the nearest integer modulo 2²², for |x| up to 2²².
///
/// In that range the low bits of x + 1.5·2²³ are the integer. Unlike a cast this is a single addition, which the compiler
/// vectorises. Other inputs, also NaN, return some number below 2²².
#[inline(always)]
pub(crate) fn round_wrapping(x: f32) -> u32 {
    const ALIGN: f32 = 12_582_912.0;
    (x + ALIGN).to_bits() & 0x003f_ffff
}

impl Mapping {
    /// Returns the coordinates of the point in the plane that a pixel shows, m.
    pub(crate) fn at(&self, u: f32, v: f32) -> Vec2 {
        let pixel = Vec3::new(1.0, u, v);
        Vec2::new(self.along.dot(pixel), self.up.dot(pixel)) / self.depth.dot(pixel)
    }

    /// Returns the coordinates, m, for [`LANES`] pixels of a row from u on.
    pub(crate) fn row(&self, u: f32, v: f32) -> ([f32; LANES], [f32; LANES]) {
        let start = |f: Vec3| f.x + u * f.y + v * f.z;
        let (along, up, depth) = (start(self.along), start(self.up), start(self.depth));
        let mut x = [0.0; LANES];
        let mut y = [0.0; LANES];
        for i in 0..LANES {
            let step = i as f32;
            let share = 1.0 / (depth + step * self.depth.y);
            x[i] = (along + step * self.along.y) * share;
            y[i] = (up + step * self.up.y) * share;
        }
        (x, y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, Stream};

    fn some_view(random: &mut Random) -> PinholeCamera {
        let mut any = |low, high| random.between(low, high);
        let pose = Affine3A::from_translation(Vec3::new(any(-2.0, 2.0), any(-2.0, 2.0), any(0.2, 0.6)))
            * Affine3A::from_rotation_z(any(-3.0, 3.0))
            * Affine3A::from_rotation_y(any(-0.3, 0.9))
            * Affine3A::from_rotation_x(any(-0.2, 0.2));
        PinholeCamera::new(pose, FOCAL, 640, 480)
    }

    #[test]
    fn the_homography_inverts_the_projection() {
        let mut random = Random::new(4, Stream::Start);
        let mut checked = 0;
        for _ in 0..1_000 {
            let view = some_view(&mut random);
            let point = Vec3::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0), 0.0);
            let seen = view.in_camera(point);
            let pixel = view.pixel(seen);
            let margin = pixel.clamp(Vec2::ZERO, Vec2::new(640.0, 480.0));
            if seen.x < 0.1 || margin != pixel {
                continue;
            }
            let found = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y).at(pixel.x, pixel.y);
            let limit = 3e-5 * (1.0 + seen.length_squared() / view.pose.translation.z);
            assert!(found.distance(point.truncate()) < limit, "{found} {point}");
            checked += 1;
        }
        assert!(checked > 50, "{checked}");
    }

    #[test]
    fn rounding_is_to_nearest_and_wraps() {
        for (x, nearest) in [(0.0, 0), (0.4, 0), (0.6, 1), (1234.4, 1234), (-0.6, (1 << 22) - 1)] {
            assert_eq!(round_wrapping(x), nearest);
        }
        for x in [f32::NAN, f32::INFINITY, -1e30] {
            assert!(round_wrapping(x) < 1 << 22);
        }
    }

    #[test]
    fn polygons_and_spheres_behind_camera_are_clipped() {
        let view = PinholeCamera::new(Affine3A::IDENTITY, FOCAL, 320, 240);
        let behind = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(-1.0, 1.0, 0.0), Vec3::new(-2.0, 0.0, 1.0)];
        assert!(view.polygon(behind).is_empty());
        let through = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, -1.0, 0.0)];
        assert_eq!(view.polygon(through).len(), 4);
        assert!(!view.may_contain(Vec3::new(-1.0, 0.0, 0.0), 0.5));
        assert!(view.may_contain(Vec3::new(1.0, 0.0, 0.0), 0.5));
        assert!(!view.may_contain(Vec3::new(1.0, 2.0, 0.0), 0.5));
    }
}
