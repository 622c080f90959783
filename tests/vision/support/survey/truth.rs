//! Ground truth of an image.

use bica_field::{FIELD, GoalColour};
use bica_motion::kinematics;
use bica_motion::model::NAO;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use bica_sim::PixelLabel;
use bica_sim::World;
use bica_vision::projection::Camera;
use glam::{Vec2, Vec3};

use super::view::View;

/// Width and height of the image, px.
pub(super) const SIZE: (usize, usize) = (320, 240);

/// Ground truth of one image, from the referee.
pub(super) struct Truth {
    /// Ground frame in the field frame.
    pub(super) pose: Pose2,
    pub(super) camera: Camera,
    /// Field frame.
    pub(super) ball: Vec2,
    pub(super) others: Vec<Pose2>,
    pub(super) attacks_yellow: bool,
    things: Vec<PixelLabel>,
}

impl Truth {
    pub(super) fn of(view: &mut View) -> Self {
        let things = view.world.segmentation_mask();
        let sensors = view.world.sensors();
        let image = sensors.image.expect("there is a new one");
        let camera = Camera::of(NAO, image.camera, &sensors.angles, Side::Left, image.width, image.height);
        let hips = kinematics::ground_from_robot(NAO, Side::Left, &sensors.angles).translation;
        let referee = view.world.referee();
        Self {
            pose: referee.robot() * Pose2::new(-hips.x, -hips.y, 0.0),
            camera,
            ball: referee.ball(),
            others: referee.others().to_vec(),
            attacks_yellow: referee.attacks() == GoalColour::Yellow,
            things,
        }
    }

    /// Distance of a field point from the robot, m.
    pub(super) fn distance(&self, place: Vec2) -> f32 {
        self.pose.locate(place).length()
    }

    /// Pixel of a point of the field frame, without occlusion; may be outside the image.
    pub(super) fn pixel(&self, point: Vec3) -> Option<Vec2> {
        self.camera.pixel(self.pose.locate(point.truncate()).extend(point.z))
    }

    /// Label of a pixel; `None` outside the image.
    pub(super) fn thing(&self, pixel: Vec2) -> Option<PixelLabel> {
        let (x, y) = ((pixel.x + 0.5).floor(), (pixel.y + 0.5).floor());
        let is_inside = x >= 0.0 && y >= 0.0 && x < SIZE.0 as f32 && y < SIZE.1 as f32;
        is_inside.then(|| self.things[y as usize * SIZE.0 + x as usize])
    }

    /// Returns whether a point of the field frame is visible with a label.
    pub(super) fn shows(&self, point: Vec3, thing: PixelLabel) -> bool {
        self.pixel(point).is_some_and(|pixel| self.thing(pixel) == Some(thing))
    }

    /// Number of pixels with a label.
    pub(super) fn area(&self, thing: PixelLabel) -> usize {
        self.things.iter().filter(|shown| **shown == thing).count()
    }

    /// Returns whether a point of the ground frame is on the carpet.
    pub(super) fn is_carpet(&self, ground: Vec2) -> bool {
        let place = self.pose.place(ground).abs();
        place.x < FIELD.carpet_corner().x && place.y < FIELD.carpet_corner().y
    }
}
