//! Self-localization on the field.

use bica::prelude::*;
use bica::visual::{self, Point2};
use bica_field::FieldDimensions;
use bica_motion::pose::{Pose2, rotate};
use glam::Vec2;
use libm::atan2f;

use super::CameraPose;
use crate::league::FIELD;
use crate::league::input::CameraInput;
use crate::league::senses::Object;
use crate::perception::Odometry;
use crate::perception::ego_motion::EgoMotion;
use crate::shapes;

/// Least number of marks in a view that give a pose.
const MARKS: f32 = 2.0;
/// Least root mean square of the marks' distances from their middle that gives a heading, m.
const SPREAD: f32 = 1.0;

/// The robot's pose on the field, from the directions and distances of known marks, and from odometry between two views.
#[derive(Debug)]
pub struct Localization {
    pose: Option<Pose2>,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 20)]
impl Localization {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { pose: None, ego_motion: EgoMotion::new() }
    }

    fn step(&mut self, time: &Time, input: &CameraInput, camera: &CameraPose, odometry: &Odometry) {
        let pose = &mut self.pose;
        let advance = |motion, seconds: f32| *pose = pose.filter(|_| seconds.is_finite()).map(|pose| pose * motion);
        if self.ego_motion.begin_run(time, odometry, input, advance) {
            let marks = input.sights().iter().filter_map(|sight| match sight.object {
                Object::Mark([x, y, z]) => Some((Vec2::new(x, y), camera.ground(sight.at, z)?)),
                _ => None,
            });
            self.pose = pose_by(marks).or(self.pose);
        }
    }

    /// Counts a cycle since the last run and the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// Most probable pose on the field: x towards the attacked goal, from the centre.
    #[output(frame = "field")]
    fn robot_pose(&self) -> Option<visual::Pose2> {
        self.pose().map(shapes::pose)
    }

    /// Most probable pose of the odometry's frame on the field.
    #[output(frame = "field", child = "odometry")]
    fn odometry_origin(&self) -> Option<visual::Pose2> {
        self.pose().map(|pose| shapes::pose(pose * self.ego_motion.pose().inverse()))
    }

    /// Left and right post of the attacked goal by the pose.
    #[output(unit = "m", frame = "robot")]
    fn post_positions(&self) -> Option<[Point2; 2]> {
        self.posts().map(|posts| posts.map(shapes::point))
    }

    /// The pose of the point on the ground between the feet in the field frame, x towards the attacked goal; `None` before the first
    /// view with marks, and if the motion of the robot is not known.
    #[must_use]
    pub const fn pose(&self) -> Option<Pose2> {
        if self.ego_motion.is_fresh() { self.pose } else { None }
    }

    /// The left and the right post of the attacked goal, m, in the ground frame between the feet; `None` while the pose is unknown.
    #[must_use]
    pub fn posts(&self) -> Option<[Vec2; 2]> {
        let pose = self.pose()?;
        Some(FIELD.goal_posts(true).map(|post| pose.locate(post)))
    }

    /// The field.
    #[must_use]
    pub const fn field(&self) -> &'static FieldDimensions {
        FIELD
    }
}

/// Returns the pose in which marks of the field (first) appear where they are seen (second), with the least sum of squares (Arun,
/// Huang, Blostein 1987, in the plane); `None` if they are too few or too close together.
fn pose_by(marks: impl Iterator<Item = (Vec2, Vec2)> + Clone) -> Option<Pose2> {
    let count = marks.clone().count() as f32;
    let sum = marks.clone().fold([Vec2::ZERO; 2], |[field, seen], (mark, at)| [field + mark, seen + at]);
    let [field, seen] = sum.map(|sum| sum / count.max(1.0));
    let (turned, straight, spread) = marks.fold((0.0, 0.0, 0.0), |(turned, straight, spread), (mark, at)| {
        let (mark, at) = (mark - field, at - seen);
        (turned + at.perp_dot(mark), straight + at.dot(mark), spread + mark.length_squared())
    });
    if count < MARKS || spread < count * SPREAD * SPREAD {
        return None;
    }
    let heading = atan2f(turned, straight);
    Some(Pose2 { position: field - rotate(seen, heading), heading })
}
