//! The attacked goal.

mod params;

use bica::prelude::*;
use bica::visual::{Ellipse, ImageSegment, Point2};
use bica_field::{FIELD, GoalColour};
use bica_motion::pose::rotate;
use bica_vision::frame::Frame;
use bica_vision::gap;
use bica_vision::goal::{Goal, GoalDetection, GoalFinder, Goals, Post, PostSide};
use bica_vision::memory::{Memory, PositionEstimate, visibility};
use bica_vision::projection::Camera;
use bica_vision::uncertainty::{self, Covariance, Errors};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{CameraInput, Colours};
use crate::shapes;

pub use params::GoalTracking;

/// Standard deviation of the middle of the goal from one post of unknown side, m.
const HALF_GOAL: f32 = 0.5 * FIELD.goal_width();

/// Standard deviation of a goal whose post bases are not on the ground, m.
const UNSURE: f32 = 0.5;

/// Finds the attacked goal in the image (the paper's "net") and remembers its position.
pub struct GoalDetector {
    finder: GoalFinder<512>,
    attacked: GoalColour,
    goals: Goals,
    seen: Option<Goal>,
    /// Both posts were seen at once since the last restart of the search.
    complete: bool,
    /// Whether a part of the goal was seen since the last restart of the search.
    found: bool,
    /// Unit vector from the right post to the left one, in the frame of the odometry.
    across: Vec2,
    gap: Option<f32>,
    memory: Memory,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 500)]
impl GoalDetector {
    /// Creates the component with the yellow goal attacked.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            finder: GoalFinder::new(),
            attacked: GoalColour::Yellow,
            goals: Goals { yellow: None, blue: None },
            seen: None,
            complete: false,
            found: false,
            across: Vec2::Y,
            gap: None,
            memory: Memory::new(GoalTracking::DEFAULT.half_life),
            ego_motion: EgoMotion::new(),
        }
    }

    fn step(
        &mut self,
        detection: &Tuned<GoalDetection>,
        tracking: &Tuned<GoalTracking>,
        time: &Time,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.memory.set_tuning(&tracking.tuning(odometry));
        let advance = |motion, seconds| self.memory.advance(motion, seconds);
        if !self.ego_motion.begin_run(time, odometry, input, advance) {
            return;
        }
        self.goals = self.look(detection, input, colours, end, pose);
        self.seen = if self.attacked == GoalColour::Yellow { self.goals.yellow } else { self.goals.blue };
        match (self.seen, pose.camera()) {
            (Some(goal), Some(camera)) => {
                self.remember(detection, tracking, &goal, camera, pose.errors());
                self.measure_gap(detection, &goal, camera, input, colours);
            }
            (None, Some(camera)) if pose.is_steady() => self.reduce_confidence(tracking, input, camera, own),
            _ => {}
        }
    }

    fn look(
        &mut self,
        detection: &GoalDetection,
        input: &CameraInput,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
    ) -> Goals {
        let Ok(frame) = Frame::from_image(&input.image()) else { return Goals::default() };
        let camera = pose.camera().map(|camera| (camera, pose.errors()));
        self.finder.find_tuned(&frame, colours.table(), end.line(), camera, detection)
    }

    /// Updates the remembered goal: two posts determine its position; one post corrects it, or gives a first estimate.
    fn remember(
        &mut self,
        detection: &GoalDetection,
        tracking: &GoalTracking,
        goal: &Goal,
        camera: &Camera,
        errors: &Errors,
    ) {
        let spread = || Self::spread(goal, camera, errors);
        let (both, one) = (tracking.two_posts_confidence, tracking.one_post_confidence);
        let Some(first) = goal.first.ground(camera) else { return };
        if let Some(second) = goal.second.and_then(|post| post.ground(camera)) {
            let across = first - second;
            if (across.length() - FIELD.goal_width()).abs() < detection.max_width_error * FIELD.goal_width() {
                self.across = rotate(across.normalize(), self.ego_motion.pose().heading);
                (self.complete, self.found) = (true, true);
                self.memory.see(0.5 * (first + second), &spread(), both);
            }
        } else if let Some(known) = self.memory.position() {
            let middle = middle_by(first, goal.first.side, self.across(), known);
            if middle.distance(known) < tracking.max_correction {
                self.found = true;
                self.memory.see(middle, &spread(), one);
            } else if goal.first.has_base {
                // Whether there is a post where the remembered goal has none.
                self.memory.miss();
            }
        } else if let Some(middle) = goal.ground(camera) {
            self.across = rotate(middle.normalize_or_zero().perp(), self.ego_motion.pose().heading);
            self.found = true;
            self.memory.see(middle, &(spread() + uncertainty::round(HALF_GOAL)), one);
        }
    }

    /// Reduces the confidence in a remembered goal of which a sharp image should show both posts.
    fn reduce_confidence(&mut self, tracking: &GoalTracking, input: &CameraInput, camera: &Camera, own: &OwnBody) {
        let Some(place) = self.memory.estimate() else { return };
        let size = Vec2::new(input.image().width.into(), input.image().height.into());
        let half = 0.5 * FIELD.goal_width() * self.across();
        let posts = [half, -half].map(|aside| PositionEstimate { position: place.position + aside, ..place });
        let (radius, far) = (FIELD.post_radius(), tracking.visible_distance);
        if posts.iter().all(|post| visibility::is_in_view(camera, size, own.body(), post, radius, far)) {
            self.memory.miss();
        }
    }

    /// The covariance of the post bases on the ground, m².
    fn spread(goal: &Goal, camera: &Camera, errors: &Errors) -> Covariance {
        let feet = [Some(goal.first), goal.second].into_iter().flatten();
        let spread =
            feet.filter_map(|post| uncertainty::of_ground(camera, post.base, 0.0, errors)).reduce(|a, b| a + b);
        spread.map_or(uncertainty::round(UNSURE), |spread| spread * if goal.second.is_some() { 0.5 } else { 1.0 })
    }

    /// Measures the gap beside the keeper, if both posts are in view.
    fn measure_gap(
        &mut self,
        detection: &GoalDetection,
        goal: &Goal,
        camera: &Camera,
        input: &CameraInput,
        colours: &Colours,
    ) {
        let place = |post: Post| post.ground(camera).filter(|_| post.has_base);
        let posts = place(goal.first).zip(goal.second.and_then(place));
        let (Some((left, right)), Ok(frame)) = (posts, Frame::from_image(&input.image())) else { return };
        let gap = gap::widest(&frame, colours.table(), camera, left, right);
        if let Some(gap) = gap.filter(|gap| gap.width() > detection.min_gap) {
            self.gap = Some(FIELD.goal_width() * (0.5 - gap.middle()));
        }
    }

    /// Sets the colour of the attacked goal and forgets the remembered one.
    pub fn attack(&mut self, colour: GoalColour) {
        self.attacked = colour;
        self.complete = false;
        self.gap = None;
        self.memory.forget();
    }

    /// The colour of the attacked goal.
    #[output]
    #[must_use]
    pub const fn attacked(&self) -> GoalColour {
        self.attacked
    }

    /// Restarts the search: only later sightings count as found; the remembered position is kept.
    pub const fn restart_search(&mut self) {
        (self.complete, self.found) = (false, false);
    }

    /// Counts a cycle since the last run and the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// Both goals in the newest image; none if that is older than half a second.
    #[must_use]
    pub const fn goals(&self) -> &Goals {
        if self.ego_motion.has_image() { &self.goals } else { &Goals { yellow: None, blue: None } }
    }

    /// The attacked goal in the newest image; `None` if that is older than half a second.
    #[must_use]
    pub const fn seen(&self) -> Option<&Goal> {
        if self.ego_motion.has_image() { self.seen.as_ref() } else { None }
    }

    /// Left or only post, and right post, of the attacked goal in the newest image, from the base to the top.
    #[output(unit = "px", frame = "camera")]
    fn posts_in_image(&self) -> [Option<ImageSegment>; 2] {
        let posts = self.seen().map_or([None; 2], |goal| [Some(goal.first), goal.second]);
        let segment = |post: Post| ImageSegment { start: shapes::pixel(post.base), end: shapes::pixel(post.top) };
        posts.map(|post| post.map(segment))
    }

    /// Whether the newest image shows the yellow and the sky-blue goal.
    #[output]
    const fn seen_goals(&self) -> [bool; 2] {
        [self.goals().yellow.is_some(), self.goals().blue.is_some()]
    }

    /// Whether both posts were seen at once since the search was restarted.
    #[output]
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.complete
    }

    /// Whether a part of the remembered goal was seen since the search was restarted.
    #[output]
    #[must_use]
    pub const fn is_found(&self) -> bool {
        self.found
    }

    /// The unit vector along the goal line, from the right post to the left one, in the ground frame.
    #[must_use]
    pub fn across(&self) -> Vec2 {
        rotate(self.across, -self.ego_motion.pose().heading)
    }

    /// The middle of the widest gap, m to the left of the middle of the goal; `None` if both posts were never in view
    /// at the same time.
    #[output(unit = "m")]
    #[must_use]
    pub const fn gap(&self) -> Option<f32> {
        self.gap
    }

    /// The position of the middle of the goal, m, in the ground frame between the feet; `None` if it is forgotten, or the motion of
    /// the robot is not known.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.estimate().map(|place| place.position)
    }

    /// Middle of the goal.
    #[output(unit = "m", frame = "robot")]
    fn goal_position(&self) -> Option<Ellipse> {
        self.estimate().map(shapes::ellipse)
    }

    /// Confidence in the position, 0 to 1.
    #[output]
    const fn position_confidence(&self) -> f32 {
        self.memory.confidence()
    }

    /// Unit vector along the goal line, from the right post to the left one, in the ground frame.
    #[output]
    fn goal_line(&self) -> Point2 {
        shapes::point(self.across())
    }

    /// The same position with its covariance, m².
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.memory.estimate().filter(|_| self.ego_motion.is_fresh())
    }
}

/// The middle of a goal, from one of its posts and the unit vector along its line. For a post of unknown side, the
/// candidate that is nearer to the `known` position.
fn middle_by(post: Vec2, side: PostSide, across: Vec2, known: Vec2) -> Vec2 {
    let half = 0.5 * FIELD.goal_width() * across;
    let (if_left, if_right) = (post - half, post + half);
    let is_nearer = side == PostSide::Unknown && if_left.distance(known) < if_right.distance(known);
    if side == PostSide::Left || is_nearer { if_left } else { if_right }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn post_side_determines_the_goal_side() {
        let (left_post, goal) = (Vec2::new(2.0, 0.7), Vec2::new(2.0, 0.0));
        let elsewhere = Vec2::new(2.0, 1.4);
        assert_eq!(middle_by(left_post, PostSide::Left, Vec2::Y, elsewhere), goal);
        assert_eq!(middle_by(left_post, PostSide::Right, Vec2::Y, goal), elsewhere);
        for known in [goal, elsewhere] {
            assert_eq!(middle_by(left_post, PostSide::Unknown, Vec2::Y, known), known);
        }
    }
}
