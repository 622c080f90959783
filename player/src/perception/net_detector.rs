//! The goal to score in.

use bica::prelude::*;
use bica_field::{FIELD, GoalColour};
use bica_motion::pose::rotate;
use bica_vision::frame::Frame;
use bica_vision::gap;
use bica_vision::goal::{Goal, GoalFinder, Goals, Post, PostSide};
use bica_vision::memory::{Memory, PositionEstimate, visibility};
use bica_vision::projection::Camera;
use bica_vision::uncertainty::{self, Covariance, Errors};
use glam::Vec2;

use super::ride::Ride;
use super::{CameraPose, FieldBoundary, Odometry, OwnBody};
use crate::input::{Colours, Eye};

/// Time without a sighting in which the belief in the goal's place halves, s.
const HALF_LIFE: f32 = 20.0;
/// Two posts are believed to be a goal's if their distance is right within this part of it.
const WIDTH_ERROR: f32 = 0.3;
/// A gap narrower than this part of the goal is not aimed at.
const ROOM: f32 = 0.25;
/// A lone post is believed to be of the remembered goal if that moves the goal by less than this, m.
const SAME: f32 = 0.6;
/// A goal farther away than this may be there and not be seen, m.
const VISIBLE: f32 = 4.0;
/// How far the middle of the goal may be from where one post of unknown side says, m.
const HALF_GOAL: f32 = 0.5 * FIELD.goal_width();
/// How far off a goal may be where the feet of its posts are not seen, m.
const UNSURE: f32 = 0.5;

/// Finds the goal that the forward attacks and remembers where it is.
pub struct NetDetector {
    finder: GoalFinder<512>,
    attacked: GoalColour,
    goals: Goals,
    seen: Option<Goal>,
    whole: bool,
    found: bool,
    /// From the right post to the left one, length 1, in the frame of the odometry.
    across: Vec2,
    gap: Option<f32>,
    memory: Memory,
    ride: Ride,
}

#[component(hz = 30, budget_us = 500)]
impl NetDetector {
    /// Looks for the yellow goal.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            finder: GoalFinder::new(),
            attacked: GoalColour::Yellow,
            goals: Goals { yellow: None, blue: None },
            seen: None,
            whole: false,
            found: false,
            across: Vec2::Y,
            gap: None,
            memory: Memory::new(HALF_LIFE),
            ride: Ride::new(),
        }
    }

    fn step(
        &mut self,
        time: &Time,
        eye: &Eye,
        colours: &Colours,
        end: &FieldBoundary,
        pose: &CameraPose,
        own: &OwnBody,
        odometry: &Odometry,
    ) {
        self.memory.advance(self.ride.motion(odometry), time.dt());
        if !self.ride.sees_anew(eye) {
            return;
        }
        self.goals = self.look(eye, colours, end, pose);
        self.seen = if self.attacked == GoalColour::Yellow { self.goals.yellow } else { self.goals.blue };
        match (self.seen, pose.camera()) {
            (Some(goal), Some(camera)) => {
                self.note(&goal, camera);
                self.note_gap(&goal, camera, eye, colours);
            }
            (None, Some(camera)) if pose.is_steady() => self.note_absence(eye, camera, own),
            _ => {}
        }
    }

    fn look(&mut self, eye: &Eye, colours: &Colours, end: &FieldBoundary, pose: &CameraPose) -> Goals {
        let frame = Frame::from_image(&eye.image());
        frame.map_or(Goals::default(), |frame| self.finder.find(&frame, colours, end.line(), pose.camera()))
    }

    /// Two posts tell where the goal is; one corrects what is remembered, or is all that is known.
    fn note(&mut self, goal: &Goal, camera: &Camera) {
        let Some(first) = goal.first.ground(camera) else { return };
        if let Some(second) = goal.second.and_then(|post| post.ground(camera)) {
            let across = first - second;
            if (across.length() - FIELD.goal_width()).abs() < WIDTH_ERROR * FIELD.goal_width() {
                self.across = rotate(across.normalize(), self.ride.heading());
                (self.whole, self.found) = (true, true);
                self.memory.see(0.5 * (first + second), &Self::spread(goal, camera), 0.9);
            }
        } else if let Some(known) = self.memory.position() {
            let middle = middle_by(first, goal.first.side, self.across(), known);
            if middle.distance(known) < SAME {
                self.found = true;
                self.memory.see(middle, &Self::spread(goal, camera), 0.3);
            } else if goal.first.has_base {
                // No post of the remembered goal stands there, so it is not where it is remembered.
                self.memory.miss();
            }
        } else if let Some(middle) = goal.ground(camera) {
            self.across = rotate(middle.normalize_or_zero().perp(), self.ride.heading());
            self.found = true;
            self.memory.see(middle, &(Self::spread(goal, camera) + uncertainty::round(HALF_GOAL)), 0.3);
        }
    }

    /// A goal of which both posts should be in a sharp image, and none is, is believed less.
    fn note_absence(&mut self, eye: &Eye, camera: &Camera, own: &OwnBody) {
        let Some(place) = self.memory.estimate() else { return };
        let size = Vec2::new(eye.image().width.into(), eye.image().height.into());
        let half = 0.5 * FIELD.goal_width() * self.across();
        let posts = [half, -half].map(|aside| PositionEstimate { position: place.position + aside, ..place });
        if posts.iter().all(|post| visibility::is_in_view(camera, size, own.body(), post, FIELD.post_radius(), VISIBLE))
        {
            self.memory.miss();
        }
    }

    /// How far off the feet of the posts may be.
    fn spread(goal: &Goal, camera: &Camera) -> Covariance {
        let feet = [Some(goal.first), goal.second].into_iter().flatten();
        let spread =
            feet.filter_map(|post| uncertainty::of_ground(camera, post.base, 0.0, &Errors::NAO)).reduce(|a, b| a + b);
        spread.map_or(uncertainty::round(UNSURE), |spread| spread * if goal.second.is_some() { 0.5 } else { 1.0 })
    }

    /// The keeper is seen only together with both posts.
    fn note_gap(&mut self, goal: &Goal, camera: &Camera, eye: &Eye, colours: &Colours) {
        let place = |post: Post| post.ground(camera).filter(|_| post.has_base);
        let posts = place(goal.first).zip(goal.second.and_then(place));
        let (Some((left, right)), Ok(frame)) = (posts, Frame::from_image(&eye.image())) else { return };
        let gap = gap::widest(&frame, colours, camera, left, right);
        if let Some(gap) = gap.filter(|gap| gap.width() > ROOM) {
            self.gap = Some(FIELD.goal_width() * (0.5 - gap.middle()));
        }
    }

    /// Sets the colour of the attacked goal and forgets the remembered one.
    pub fn attack(&mut self, colour: GoalColour) {
        self.attacked = colour;
        self.whole = false;
        self.gap = None;
        self.memory.forget();
    }

    /// The colour of the goal that is attacked.
    #[must_use]
    pub const fn attacked(&self) -> GoalColour {
        self.attacked
    }

    /// Looks anew: what was seen before is only remembered.
    pub const fn look_anew(&mut self) {
        (self.whole, self.found) = (false, false);
    }

    /// Both goals in the newest image, as far as they are seen.
    #[must_use]
    pub const fn goals(&self) -> &Goals {
        &self.goals
    }

    /// The attacked goal in the newest image.
    #[must_use]
    pub const fn seen(&self) -> Option<&Goal> {
        self.seen.as_ref()
    }

    /// Whether both posts were seen at once since the detector looked anew.
    #[must_use]
    pub const fn whole(&self) -> bool {
        self.whole
    }

    /// Whether anything of the remembered goal was seen since the detector looked anew.
    #[must_use]
    pub const fn found(&self) -> bool {
        self.found
    }

    /// The direction along the goal line, from the right post to the left one, length 1.
    #[must_use]
    pub fn across(&self) -> Vec2 {
        rotate(self.across, -self.ride.heading())
    }

    /// The middle of the widest part of the goal that nobody covers, m to the left of the goal's middle; none if the
    /// whole goal line was never seen.
    #[must_use]
    pub const fn gap(&self) -> Option<f32> {
        self.gap
    }

    /// Where the middle of the goal is believed to be, m, in the frame on the ground between the feet.
    #[must_use]
    pub fn at(&self) -> Option<Vec2> {
        self.memory.position()
    }

    /// The same, with how sure that is.
    #[must_use]
    pub fn estimate(&self) -> Option<PositionEstimate> {
        self.memory.estimate()
    }
}

/// Where the middle of a goal is by one of its posts and the direction of its line; if nobody knows which post it is, the
/// place that is nearer to the known one.
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
    fn a_post_of_known_side_says_on_which_side_of_it_the_goal_is() {
        let (left_post, goal) = (Vec2::new(2.0, 0.7), Vec2::new(2.0, 0.0));
        let elsewhere = Vec2::new(2.0, 1.4);
        assert_eq!(middle_by(left_post, PostSide::Left, Vec2::Y, elsewhere), goal);
        assert_eq!(middle_by(left_post, PostSide::Right, Vec2::Y, goal), elsewhere);
        for known in [goal, elsewhere] {
            assert_eq!(middle_by(left_post, PostSide::Unknown, Vec2::Y, known), known);
        }
    }
}
