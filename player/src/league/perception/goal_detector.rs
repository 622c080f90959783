//! The attacked goal.

use bica::prelude::*;
use bica::visual::{Point2, Pose2 as VisualPose};
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::CameraPose;
use crate::league::FIELD;
use crate::league::input::CameraInput;
use crate::league::senses::Object;
use crate::perception::Odometry;
use crate::perception::ego_motion::EgoMotion;
use crate::shapes;

/// Sees the attacked goal (the paper's "net") and remembers its position.
#[derive(Debug)]
pub struct GoalDetector {
    /// Both posts were seen at once since the last restart of the search.
    complete: bool,
    /// Left and right post, m, in the ground frame between the feet.
    posts: Option<[Vec2; 2]>,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 20)]
impl GoalDetector {
    /// Creates the component without a goal.
    #[must_use]
    pub const fn new() -> Self {
        Self { complete: false, posts: None, ego_motion: EgoMotion::new() }
    }

    fn step(&mut self, time: &Time, input: &CameraInput, camera: &CameraPose, odometry: &Odometry) {
        let posts = &mut self.posts;
        let advance = |motion: Pose2, seconds: f32| {
            *posts = posts.filter(|_| seconds.is_finite()).map(|posts| posts.map(|post| motion.locate(post)));
        };
        if self.ego_motion.begin_run(time, odometry, input, advance) {
            let seen = FIELD.goal_posts(true).map(|post| {
                input.sights().iter().find_map(|sight| match sight.object {
                    Object::Mark([x, y, z]) if Vec2::new(x, y) == post => camera.ground(sight.at, z),
                    _ => None,
                })
            });
            if let [Some(left), Some(right)] = seen {
                (self.posts, self.complete) = (Some([left, right]), true);
            }
        }
    }

    /// Counts a cycle since the last run and the last image.
    pub(crate) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// The posts, while the motion of the robot is known.
    const fn posts(&self) -> Option<[Vec2; 2]> {
        if self.ego_motion.is_fresh() { self.posts } else { None }
    }

    /// Restarts the search: only later sightings count as found; the remembered position is kept.
    pub const fn restart_search(&mut self) {
        self.complete = false;
    }

    /// Whether both posts were seen at once since the search was restarted.
    #[output]
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.complete
    }

    /// Whether a part of the remembered goal was seen since the search was restarted: only whole goals are remembered.
    #[must_use]
    pub const fn is_found(&self) -> bool {
        self.complete
    }

    /// The unit vector along the goal line, from the right post to the left one, in the ground frame; to the left of the robot before
    /// the goal was seen.
    #[must_use]
    pub fn across(&self) -> Vec2 {
        self.posts().and_then(|[left, right]| (left - right).try_normalize()).unwrap_or(Vec2::Y)
    }

    /// The middle of the gap beside a keeper, m to the left of the middle of the goal: it is not measured.
    #[must_use]
    pub const fn gap(&self) -> Option<f32> {
        None
    }

    /// The middle of the back of the goal, m, in the ground frame between the feet: a robot that walks the ball there crosses the line,
    /// from beside a post, too.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        let depth = FIELD.goal_back() - FIELD.field_corner().x;
        self.posts().map(|[left, right]| left.midpoint(right) + depth * self.out())
    }

    /// Unit vector out of the field, in the ground frame.
    fn out(&self) -> Vec2 {
        -self.across().perp()
    }

    /// Left and right post.
    #[output(unit = "m", frame = "robot")]
    fn goal_posts(&self) -> Option<[Point2; 2]> {
        self.posts().map(|posts| posts.map(shapes::point))
    }

    /// Middle of the back of the goal, with the direction out of the field.
    #[output(unit = "m", frame = "robot")]
    fn goal(&self) -> Option<VisualPose> {
        let out = self.out();
        Some(shapes::pose(Pose2 { position: self.position()?, heading: libm::atan2f(out.y, out.x) }))
    }
}
