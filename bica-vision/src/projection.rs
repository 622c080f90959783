//! From pixels to the ground and back.
//!
//! The *ground* frame is that of [`bica_motion::kinematics::ground_from_robot`]: origin on the ground between the
//! feet, x forward, y left, z up, metres. The *camera* frame: x along the optical axis, y left, z up the image. A pixel
//! (u, v) is the ray (1, −(u − cx)/fx, −(v − cy)/fy) of the camera frame.
//!
//! Cost: 10 to 30 ns each way, no loops.

use bica_motion::joints::Joints;
use bica_motion::kinematics;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};
use libm::{atan2f, sinf, sqrtf};

/// How a camera maps directions to pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// Focal lengths, pixels.
    pub focal: Vec2,
    /// The pixel on the optical axis.
    pub centre: Vec2,
}

impl Intrinsics {
    /// Intrinsics of a robot's camera at an image size in pixels, with the optical centre in the middle of the image.
    #[must_use]
    pub fn of<M: RobotModel>(camera: CameraId, width: u16, height: u16) -> Self {
        let size = Vec2::new(f32::from(width), f32::from(height));
        Self { focal: M::DIMENSIONS.camera(camera).focal * size, centre: 0.5 * size }
    }

    /// Intrinsics of either camera of a NAO V6 at an image size in pixels.
    #[must_use]
    pub fn nao_v6(width: u16, height: u16) -> Self {
        Self::of::<Nao>(CameraId::Top, width, height)
    }
}

/// A camera over the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pose: Affine3A,
    inverse: Affine3A,
    intrinsics: Intrinsics,
}

impl Camera {
    /// A camera from its pose in the ground frame (`pose.transform_point3(p)` takes points of the camera frame to the
    /// ground frame). The rotation part must be a rotation; a pose that is not finite makes every projection none.
    #[must_use]
    pub fn new(pose: Affine3A, intrinsics: Intrinsics) -> Self {
        let turn = pose.matrix3.transpose();
        let inverse = Affine3A { matrix3: turn, translation: turn * -pose.translation };
        Self { pose, inverse, intrinsics }
    }

    /// A camera of a robot from the joint angles, standing on the sole of the `support` side; image size in pixels.
    #[must_use]
    pub fn of<M: RobotModel>(id: CameraId, angles: &Joints, support: Side, width: u16, height: u16) -> Self {
        let pose = kinematics::ground_from_robot::<M>(support, angles) * kinematics::camera::<M>(id, angles);
        Self::new(pose, Intrinsics::of::<M>(id, width, height))
    }

    /// Its pose in the ground frame.
    #[must_use]
    pub const fn pose(&self) -> Affine3A {
        self.pose
    }

    /// How it maps directions to pixels.
    #[must_use]
    pub const fn intrinsics(&self) -> Intrinsics {
        self.intrinsics
    }

    /// The direction in which a pixel looks, ground frame, with length 1 along the optical axis.
    #[must_use]
    pub fn ray(&self, pixel: Vec2) -> Vec3 {
        let offset = (pixel - self.intrinsics.centre) / self.intrinsics.focal;
        self.pose.transform_vector3(Vec3::new(1.0, -offset.x, -offset.y))
    }

    /// The angles by which a pixel is off the optical axis, rad: positive x to the left, positive y down, as a head's
    /// yaw and pitch would have to turn.
    #[must_use]
    pub fn offset(&self, pixel: Vec2) -> Vec2 {
        let offset = (pixel - self.intrinsics.centre) / self.intrinsics.focal;
        Vec2::new(atan2f(-offset.x, 1.0), atan2f(offset.y, 1.0))
    }

    /// What a pixel sees in the plane `z` metres above the ground: its x and y. None if it looks past the plane.
    #[must_use]
    pub fn ground(&self, pixel: Vec2, z: f32) -> Option<Vec2> {
        let ray = self.ray(pixel);
        let eye: Vec3 = self.pose.translation.into();
        let along = (z - eye.z) / ray.z;
        let point = (eye + along * ray).truncate();
        (along > 0.0 && point.is_finite()).then_some(point)
    }

    /// The pixel, not always within the image, that shows a point of the ground frame. None if the point is behind
    /// the camera or less than 1 cm before it.
    #[must_use]
    pub fn pixel(&self, point: Vec3) -> Option<Vec2> {
        let seen = self.inverse.transform_point3(point);
        let pixel = self.intrinsics.centre - Vec2::new(seen.y, seen.z) / seen.x * self.intrinsics.focal;
        (seen.x > 0.01 && pixel.is_finite()).then_some(pixel)
    }

    /// The row of the horizon in a column: what is level with the camera. None if the camera looks straight up or
    /// down or hangs upside down.
    #[must_use]
    pub fn horizon(&self, x: f32) -> Option<f32> {
        let Intrinsics { focal, centre } = self.intrinsics;
        let (forward, left, up) = (self.pose.matrix3.x_axis.z, self.pose.matrix3.y_axis.z, self.pose.matrix3.z_axis.z);
        let row = centre.y + focal.y * (forward - left * (x - centre.x) / focal.x) / up;
        (up > 0.0 && row.is_finite()).then_some(row)
    }

    /// The distance of a sphere's centre from the camera, m, by the angle that its image subtends. `radius` in metres,
    /// `pixels` the radius in the image. None if it is not positive.
    #[must_use]
    pub fn distance_by_radius(&self, centre: Vec2, pixels: f32, radius: f32) -> Option<f32> {
        let axis = self.ray(centre);
        let angle = |dx: f32, dy: f32| {
            let edge = self.ray(centre + pixels * Vec2::new(dx, dy));
            atan2f(axis.cross(edge).length(), axis.dot(edge))
        };
        let mean = (angle(1.0, 0.0) + angle(-1.0, 0.0) + angle(0.0, 1.0) + angle(0.0, -1.0)) / 4.0;
        let distance = radius / sinf(mean);
        (pixels > 0.0 && distance > 0.0 && distance.is_finite()).then_some(distance)
    }

    /// The centre of a sphere of `radius` metres by its place and size in the image alone, ground frame. None as
    /// [`distance_by_radius`](Self::distance_by_radius).
    #[must_use]
    pub fn place_by_radius(&self, centre: Vec2, pixels: f32, radius: f32) -> Option<Vec3> {
        let distance = self.distance_by_radius(centre, pixels, radius)?;
        let eye: Vec3 = self.pose.translation.into();
        let point = eye + distance * self.ray(centre).normalize_or_zero();
        point.is_finite().then_some(point)
    }

    /// How large a sphere at a place of the ground frame is in the image: mean radius, pixels. None if it is behind
    /// the camera or around it.
    #[must_use]
    pub fn sphere_radius(&self, place: Vec3, radius: f32) -> Option<f32> {
        let seen = self.inverse.transform_point3(place);
        let depth = sqrtf(seen.x * seen.x - radius * radius);
        // Off the axis the image is an ellipse, longer away from the centre by 1/cos of the angle.
        let stretch = sqrtf(seen.length() / seen.x);
        let focal = 0.5 * (self.intrinsics.focal.x + self.intrinsics.focal.y);
        let pixels = focal * radius / depth * stretch;
        (seen.x > radius && pixels.is_finite()).then_some(pixels)
    }
}
