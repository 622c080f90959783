//! The robot's own body in the image.
//!
//! Chest, shoulders, arms, legs and feet are capsules: line segments with a radius, see [`RobotModel::body_shape`]. A
//! pixel shows the body if its ray meets a capsule. This is exact for parts close to the camera and at the image edge,
//! where projected circles are not.
//!
//! Cost: 1 µs for the capsules of an image, 0.1 µs for a pixel.

use bica_motion::joints::Joints;
use bica_motion::kinematics;
use bica_motion::model::{CameraMount, Capsule as Shape, RobotModel};
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};
use heapless::Vec;

use crate::projection::{Camera, Intrinsics, Mounting};

/// Upper bound, above √0.8, on the distance of the points of [`OwnBody::share`] from the middle, in radii.
const SHARE_EXTENT: f32 = 0.9;
/// Bound on the rounding errors of distances, m.
const ROUNDING: f32 = 1e-4;
/// Maximum number of capsules: two of the trunk, seven on each side.
const PARTS: usize = 16;

/// Parts of the image that the robot's own body covers.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnBody {
    parts: Vec<Capsule, PARTS>,
    intrinsics: Intrinsics,
}

/// Points within `radius` of a line segment; camera frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Capsule {
    from: Vec3,
    along: Vec3,
    radius: f32,
}

impl OwnBody {
    /// No body: covers nothing.
    pub const NONE: Self = Self { parts: Vec::new(), intrinsics: Intrinsics { focal: Vec2::ONE, centre: Vec2::ZERO } };

    /// Body of a robot as its camera `id` sees it at these joint angles, rad. Only the intrinsics of `camera` are used:
    /// the body is fixed to the camera, not to the ground.
    #[must_use]
    pub fn of(model: &'static RobotModel, camera: &Camera, id: CameraId, angles: &Joints) -> Self {
        Self::of_mounted(model, camera, id, angles, &Mounting::EXACT)
    }

    /// Body as [`of`](Self::of), seen by a camera with a corrected mounting.
    #[must_use]
    pub fn of_mounted(
        model: &'static RobotModel,
        camera: &Camera,
        id: CameraId,
        angles: &Joints,
        mounting: &Mounting,
    ) -> Self {
        let nominal = kinematics::camera(model, id, angles);
        let pose = mounting.rotation().map_or(nominal, |rotation| nominal * rotation);
        Self::seen_from(model, pose, camera.intrinsics(), angles)
    }

    /// The same body with all parts thicker by a margin, m.
    #[must_use]
    pub fn grown(mut self, margin: f32) -> Self {
        if margin != 0.0 {
            self.parts.iter_mut().for_each(|part| part.radius += margin);
        }
        self
    }

    /// Share of the image that shows the body, 0 to 1, estimated from 192 points.
    #[must_use]
    pub fn image_share(&self) -> f32 {
        let cell = self.intrinsics.centre / Vec2::new(8.0, 6.0);
        let points = (0..12_u8).flat_map(|v| (0..16_u8).map(move |u| Vec2::new(f32::from(u), f32::from(v)) + 0.5));
        points.filter(|point| self.covers(*point * cell)).count() as f32 / 192.0
    }

    /// Body without known joint angles: the robot stands upright over the origin, faces along x and lets its
    /// arms hang. The pose of `camera` gives the view.
    #[must_use]
    pub fn standing(model: &'static RobotModel, camera: &Camera, id: CameraId) -> Self {
        let CameraMount { position, tilt, .. } = model.dimensions.camera(id);
        let turn = Affine3A { translation: glam::Vec3A::ZERO, ..camera.pose() };
        let head = turn * Affine3A::from_rotation_y(-tilt);
        let at = model.dimensions.neck + head.transform_vector3(position);
        let hips = Vec3::from(camera.pose().translation) - at;
        let mut angles = model.stand;
        for side in Side::BOTH {
            let ankle = Vec3::new(0.0, side.sign() * model.dimensions.hip.y, model.dimensions.foot_height) - hips;
            model.leg_angles_at(side, &Affine3A::from_translation(ankle), 0.0).write(model, side, &mut angles);
        }
        Self::seen_from(model, Affine3A { translation: at.into(), ..turn }, camera.intrinsics(), &angles)
    }

    fn seen_from(model: &'static RobotModel, camera: Affine3A, intrinsics: Intrinsics, angles: &Joints) -> Self {
        let mut body = Self { parts: Vec::new(), intrinsics };
        let turn = camera.matrix3.transpose();
        let camera = Affine3A { matrix3: turn, translation: turn * -camera.translation };
        let [trunk, chest] = &model.body_shape.torso;
        body.add(&camera, Side::Left, trunk);
        body.add(&camera, Side::Left, chest);
        for side in Side::BOTH {
            body.add_arm(model, &camera, side, angles);
            body.add_leg(model, &camera, side, angles);
        }
        body
    }

    #[inline(never)]
    fn add_arm(&mut self, model: &'static RobotModel, camera: &Affine3A, side: Side, angles: &Joints) {
        let [_, biceps, _, forearm, _] = kinematics::arm(model, side, angles);
        let shape = model.body_shape;
        self.add(&(*camera * biceps), side, &shape.biceps[0]);
        self.add(&(*camera * biceps), side, &shape.biceps[1]);
        self.add(&(*camera * forearm), side, &shape.forearm);
    }

    #[inline(never)]
    fn add_leg(&mut self, model: &'static RobotModel, camera: &Affine3A, side: Side, angles: &Joints) {
        let [_, _, thigh, tibia, _, foot] = kinematics::leg(model, side, angles);
        let shape = model.body_shape;
        self.add(&(*camera * thigh), side, &shape.thigh);
        self.add(&(*camera * tibia), side, &shape.tibia);
        self.add(&(*camera * foot), side, &shape.foot[0]);
        self.add(&(*camera * foot), side, &shape.foot[1]);
    }

    fn add(&mut self, pose: &Affine3A, side: Side, shape: &Shape) {
        let [from, to] =
            [shape.from, shape.to].map(|[x, y, z]| pose.transform_point3(Vec3::new(x, side.sign() * y, z)));
        let radius = shape.radius;
        // The capacity is enough for all parts.
        let _ = self.parts.push(Capsule { from, along: to - from, radius });
    }

    /// Whether a pixel shows the body. False for a pose that is not finite.
    #[must_use]
    pub fn covers(&self, pixel: Vec2) -> bool {
        self.touches(pixel, 0.0)
    }

    /// Whether a circle in the image, centre and radius in px, touches the body, approximately.
    #[must_use]
    pub fn touches(&self, centre: Vec2, radius: f32) -> bool {
        let ray = self.ray(centre);
        let margin = radius * ray.x / self.intrinsics.focal.x;
        self.parts.iter().any(|part| part.is_near(ray, margin))
    }

    /// Returns whether a ray within `angle` (rad) of the pixel's ray may hit the body; conservatively `true`.
    fn is_close(&self, pixel: Vec2, angle: f32) -> bool {
        let ray = self.ray(pixel);
        self.parts.iter().any(|part| !part.is_far(ray, angle))
    }

    /// Unit vector through a pixel, camera frame.
    fn ray(&self, pixel: Vec2) -> Vec3 {
        let Intrinsics { focal, centre } = self.intrinsics;
        let offset = (pixel - centre) / focal;
        Vec3::new(1.0, -offset.x, -offset.y).normalize()
    }

    /// Share of a circle in the image that shows the body, 0 to 1, estimated from 25 points.
    #[must_use]
    pub fn share(&self, centre: Vec2, radius: f32) -> f32 {
        let focal = self.intrinsics.focal.min_element();
        // Most circles are far from the body. An angle is at most its tangent.
        if !self.is_close(centre, SHARE_EXTENT * radius / focal) {
            return 0.0;
        }
        let mut hits = 0_u8;
        let mut points = 0_u8;
        for v in -3..=3_i8 {
            for u in -3..=3_i8 {
                let offset = Vec2::new(f32::from(u), f32::from(v)) / 3.2;
                if offset.length_squared() <= 0.8 {
                    points += 1;
                    hits += u8::from(self.covers(centre + radius * offset));
                }
            }
        }
        f32::from(hits) / f32::from(points)
    }
}

impl Capsule {
    /// Whether the ray from the camera along the unit vector `ray` comes within the radius plus `margin` times the distance.
    fn is_near(&self, ray: Vec3, margin: f32) -> bool {
        let (away, share) = self.nearest(ray);
        let ahead = (self.from + share * self.along).dot(ray);
        ahead > 0.0 && away.length() <= self.radius + margin * ahead
    }

    /// Returns whether no ray within `angle` (rad) of `ray` hits the capsule; conservatively `false`.
    fn is_far(&self, ray: Vec3, angle: f32) -> bool {
        let (away, _) = self.nearest(ray);
        let reach = self.from.length() + self.along.length();
        away.length() > self.radius + angle * reach + ROUNDING
    }

    /// Perpendicular vector from the ray to the nearest point of the segment, and that point's position along the segment, 0 to 1.
    fn nearest(&self, ray: Vec3) -> (Vec3, f32) {
        let across = |v: Vec3| v - v.dot(ray) * ray;
        let (from, along) = (across(self.from), across(self.along));
        let length = along.length_squared();
        let share = if length > 1e-9 { (-from.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        (from + share * along, share)
    }
}

impl Default for OwnBody {
    fn default() -> Self {
        Self::NONE
    }
}
