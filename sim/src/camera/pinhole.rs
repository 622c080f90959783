//! A pinhole camera over the field.
//!
//! Camera frame: x along the optical axis, y to the left of the image, z up the image. Pixels: u to the right, v down,
//! the middle of the first pixel at (0, 0), the optical axis at half the width and half the height.

use glam::{Affine3A, Vec2, Vec3};

use crate::spectator::FIELD_OF_VIEW;

/// Focal lengths over width and height. Source: B-Human 2023 and HULKs 2025 (618.66 and 617.16 px at 640×480).
pub(crate) const FOCAL: (f32, f32) = (618.66 / 640.0, 617.16 / 480.0);
/// Nothing nearer than this is drawn, m.
pub(crate) const NEAR: f32 = 0.01;

/// A camera at a place, with its image size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PinholeCamera {
    /// Field from camera.
    pub(crate) pose: Affine3A,
    to_camera: Affine3A,
    pub(crate) focal: Vec2,
    centre: Vec2,
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl PinholeCamera {
    pub(crate) fn new(pose: Affine3A, width: usize, height: usize) -> Self {
        let size = Vec2::new(width as f32, height as f32);
        let focal = size * Vec2::new(FOCAL.0, FOCAL.1);
        Self { pose, to_camera: pose.inverse(), focal, centre: size / 2.0, width, height }
    }

    /// An onlooker's camera, whose picture has a height of [`FIELD_OF_VIEW`].
    pub(crate) fn of_onlooker(pose: Affine3A, width: usize, height: usize) -> Self {
        let focal = Vec2::splat(height as f32 / 2.0 / libm::tanf(FIELD_OF_VIEW / 2.0));
        Self { focal, ..Self::new(pose, width, height) }
    }

    /// A point of the field frame in the camera frame.
    pub(crate) fn seen(&self, point: Vec3) -> Vec3 {
        self.to_camera.transform_point3(point)
    }

    /// Where a point of the camera frame that lies ahead is in the image.
    pub(crate) fn pixel(&self, point: Vec3) -> Vec2 {
        self.centre - self.focal * Vec2::new(point.y, point.z) / point.x
    }

    /// The direction of a pixel's ray in the camera frame, x = 1.
    pub(crate) fn ray(&self, u: f32, v: f32) -> Vec3 {
        let offset = (self.centre - Vec2::new(u, v)) / self.focal;
        Vec3::new(1.0, offset.x, offset.y)
    }

    /// Whether a sphere given in the camera frame may be in the image.
    pub(crate) fn may_see(&self, centre: Vec3, radius: f32) -> bool {
        let half = self.centre / self.focal;
        let inside = |across: f32, tan: f32| across.abs() - centre.x * tan <= radius * (1.0 + tan);
        centre.x > NEAR - radius && inside(centre.y, half.x) && inside(centre.z, half.y)
    }

    /// A flat polygon of the field frame in the image; clipped where it comes too near, so it may be empty.
    pub(crate) fn polygon(&self, corners: impl IntoIterator<Item = Vec3>) -> Vec<Vec2> {
        let corners: Vec<Vec3> = corners.into_iter().map(|corner| self.seen(corner)).collect();
        Self::clip(&corners).into_iter().map(|corner| self.pixel(corner)).collect()
    }

    /// Cuts off what is nearer than [`NEAR`] (Sutherland and Hodgman 1974).
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

    /// How pixels map to a plane of the field frame with an origin and two perpendicular unit vectors.
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

/// Maps pixels to coordinates of a plane: each a quotient of two linear functions of 1, u and v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mapping {
    along: Vec3,
    up: Vec3,
    depth: Vec3,
}

/// How many pixels are mapped at once.
pub(crate) const LANES: usize = 32;

/// The nearest whole number, modulo 2²² and so also of negative ones; for numbers up to 2²² in size.
///
/// In that range a float of 1.5·2²³ has a whole number in its last bits. Unlike a cast this is a single addition, and
/// the compiler makes one of many at once. What is out of range or no number gives some number below 2²².
#[inline(always)]
pub(crate) fn whole(x: f32) -> u32 {
    const ALIGN: f32 = 12_582_912.0;
    (x + ALIGN).to_bits() & 0x003f_ffff
}

impl Mapping {
    /// The plane's coordinates seen at a pixel, m.
    pub(crate) fn at(&self, u: f32, v: f32) -> Vec2 {
        let pixel = Vec3::new(1.0, u, v);
        Vec2::new(self.along.dot(pixel), self.up.dot(pixel)) / self.depth.dot(pixel)
    }

    /// The coordinates seen at [`LANES`] pixels of a row from u on.
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
    use bica_motion::model::Nao;

    fn some_view(random: &mut Random) -> PinholeCamera {
        let mut any = |low, high| random.between(low, high);
        let pose = Affine3A::from_translation(Vec3::new(any(-2.0, 2.0), any(-2.0, 2.0), any(0.2, 0.6)))
            * Affine3A::from_rotation_z(any(-3.0, 3.0))
            * Affine3A::from_rotation_y(any(-0.3, 0.9))
            * Affine3A::from_rotation_x(any(-0.2, 0.2));
        PinholeCamera::new(pose, 640, 480)
    }

    #[test]
    fn a_plane_s_point_is_where_its_pixel_says() {
        let mut random = Random::new(4, Stream::Start);
        for _ in 0..1_000 {
            let view = some_view(&mut random);
            let point = Vec3::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0), 0.0);
            let seen = view.seen(point);
            let pixel = view.pixel(seen);
            let margin = pixel.clamp(Vec2::ZERO, Vec2::new(640.0, 480.0));
            if seen.x < 0.1 || margin != pixel {
                continue;
            }
            let found = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y).at(pixel.x, pixel.y);
            let limit = 3e-5 * (1.0 + seen.length_squared() / view.pose.translation.z);
            assert!(found.distance(point.truncate()) < limit, "{found} {point}");
        }
    }

    #[test]
    fn whole_numbers_are_nearest_and_wrap() {
        for (x, nearest) in [(0.0, 0), (0.4, 0), (0.6, 1), (1234.4, 1234), (-0.6, (1 << 22) - 1)] {
            assert_eq!(whole(x), nearest);
        }
        for x in [f32::NAN, f32::INFINITY, -1e30] {
            assert!(whole(x) < 1 << 22);
        }
    }

    #[test]
    fn published_pixels_hit_the_ground_where_published() {
        use bica_motion::{joints::Joints, kinematics::camera, robot::CameraId};
        let cases = [
            (CameraId::Top, (320.0, 479.0), (1.286, 0.0)),
            (CameraId::Top, (500.0, 400.0), (1.852, -0.525)),
            (CameraId::Bottom, (320.0, 240.0), (0.604, 0.0)),
            (CameraId::Bottom, (320.0, 479.0), (0.307, 0.0)),
            (CameraId::Bottom, (500.0, 400.0), (0.3815, -0.159)),
        ];
        for (id, (u, v), (x, y)) in cases {
            let hips = Affine3A::from_translation(Vec3::new(0.0, 0.0, 0.230));
            let view = PinholeCamera::new(hips * camera::<Nao>(id, &Joints::all(0.0)), 640, 480);
            let hit = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y).at(u, v);
            assert!(hit.distance(Vec2::new(x, y)) < 1e-3, "{id:?} {u} {v}: {hit}");
        }
    }

    #[test]
    fn nothing_behind_the_camera_is_drawn() {
        let view = PinholeCamera::new(Affine3A::IDENTITY, 320, 240);
        let behind = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(-1.0, 1.0, 0.0), Vec3::new(-2.0, 0.0, 1.0)];
        assert!(view.polygon(behind).is_empty());
        let through = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, -1.0, 0.0)];
        assert_eq!(view.polygon(through).len(), 4);
        assert!(!view.may_see(Vec3::new(-1.0, 0.0, 0.0), 0.5));
        assert!(view.may_see(Vec3::new(1.0, 0.0, 0.0), 0.5));
        assert!(!view.may_see(Vec3::new(1.0, 2.0, 0.0), 0.5));
    }
}
