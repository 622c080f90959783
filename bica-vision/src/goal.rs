//! Detection of the yellow and the sky-blue goal, each of two posts and a crossbar.
//!
//! Posts are upright bars that stand on the field and rise above its boundary. The crossbar distinguishes the left from the right
//! post when only one post is in view. Cost at 320 × 240: 30 µs for the segmentation of every second row, then 5 µs.

mod posts;

use bica_core::Params;
use bica_field::{FIELD, GoalColour};
use bica_macros::Params;
use glam::{Vec2, Vec3};

use self::posts::PostSearch;
use crate::bars;
use crate::colour::{Classify, Colour};
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::projection::Camera;
use crate::segment::{Area, Runs};
use crate::uncertainty::Errors;

/// Detection of goals in an image.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core, check = Self::is_ordered)]
pub struct GoalDetection {
    /// Minimum height of a post, as a share of the image height.
    #[param(default = 0.05, range = 0.0..=0.5, step = 0.01)]
    pub min_post_height: f32,
    /// Minimum width of a post, relative to the expected width at its position.
    #[param(default = 0.6, range = 0.0..=1.0, step = 0.05)]
    pub min_post_width: f32,
    /// Maximum width of a post, relative to the expected width at its position.
    #[param(default = 1.6, range = 1.0..=4.0, step = 0.05)]
    pub max_post_width: f32,
    /// Tolerated error of the camera's pitch in the tests of posts.
    #[param(default = 0.04, range = 0.0..=0.3, unit = "rad", step = 0.005)]
    pub pitch_error: f32,
    /// Maximum relative error of the distance between two posts of one goal.
    #[param(default = 0.3, range = 0.0..=1.0, step = 0.05)]
    pub max_width_error: f32,
    /// Minimum width of a gap to aim at, relative to the goal.
    #[param(default = 0.25, range = 0.0..=1.0, step = 0.05)]
    pub min_gap: f32,
}

impl GoalDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_post_width < self.max_post_width {
            Ok(())
        } else {
            Err("`min_post_width` must be below `max_post_width`")
        }
    }
}

/// Side of a post in its goal, seen from the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PostSide {
    /// Left post.
    Left,
    /// Right post.
    Right,
    /// Left or right post.
    Unknown,
}

/// Goal post in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Post {
    /// Side in its goal.
    pub side: PostSide,
    /// Middle of the foot, px.
    pub base: Vec2,
    /// Middle of the top, px.
    pub top: Vec2,
    /// Width, px.
    pub width: f32,
    /// Whether the foot is in the image.
    pub has_base: bool,
    /// Whether the top is in the image.
    pub has_top: bool,
}

impl Post {
    /// Position, ground frame, m: from the foot, or from the width if the foot is not in the image.
    #[must_use]
    pub fn ground(&self, camera: &Camera) -> Option<Vec2> {
        if self.has_base {
            // The image shows the foot at the front of the post, one radius before its axis.
            let front = camera.ground(self.base, 0.0)?;
            let eye = Vec3::from(camera.pose().translation).truncate();
            return Some(front + FIELD.post_radius() * (front - eye).normalize_or_zero());
        }
        let place = camera.place_by_radius(self.base, 0.5 * self.width, FIELD.post_radius())?;
        Some(place.truncate())
    }
}

/// Visible part of one goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Colour.
    pub colour: GoalColour,
    /// The only visible post, or the left one of two.
    pub first: Post,
    /// Right post of two.
    pub second: Option<Post>,
    /// Top left corner of the bounding box of posts and crossbar, px.
    pub min: Vec2,
    /// Bottom right corner of the bounding box, px.
    pub max: Vec2,
}

impl Goal {
    /// Whether both posts are visible from top to foot.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        let whole = |post: &Post| post.has_base && post.has_top;
        whole(&self.first) && self.second.as_ref().is_some_and(whole)
    }

    /// Midpoint between two posts, or the foot of a single post, px.
    #[must_use]
    pub fn middle(&self) -> Vec2 {
        self.second.map_or(self.first.base, |second| 0.5 * (self.first.base + second.base))
    }

    /// Position of the goal's centre, ground frame, m: between its posts; for a single post of a known side, half a
    /// goal width beside it, perpendicular to the line of sight; otherwise the post itself.
    #[must_use]
    pub fn ground(&self, camera: &Camera) -> Option<Vec2> {
        let first = self.first.ground(camera)?;
        if let Some(second) = self.second {
            return Some(0.5 * (first + second.ground(camera)?));
        }
        let left = first.normalize_or_zero().perp();
        Some(match self.first.side {
            PostSide::Left => first - 0.5 * FIELD.goal_width() * left,
            PostSide::Right => first + 0.5 * FIELD.goal_width() * left,
            PostSide::Unknown => first,
        })
    }
}

/// Goals of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goals {
    /// Yellow goal.
    pub yellow: Option<Goal>,
    /// Sky-blue goal.
    pub blue: Option<Goal>,
}

/// Goal detector with memory for `N` runs, 8 bytes each. `N` = 512 is enough.
#[derive(Clone, Debug)]
pub struct GoalFinder<const N: usize> {
    runs: Runs<N>,
}

impl<const N: usize> GoalFinder<N> {
    /// Creates a detector.
    #[must_use]
    pub const fn new() -> Self {
        Self { runs: Runs::new() }
    }

    /// Finds the goals of a frame. Segments yellow and blue only. With `camera`, bars that end below the horizon or
    /// have a wrong width for their position are rejected.
    pub fn find(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        field_boundary: &FieldBoundary,
        camera: Option<&Camera>,
    ) -> Goals {
        self.find_tuned(
            frame,
            colours,
            field_boundary,
            camera.map(|camera| (camera, &Errors::NAO)),
            &GoalDetection::DEFAULT,
        )
    }

    /// Finds the goals as [`find`](Self::find) does, with thresholds of the caller and the errors of the camera's pose.
    pub fn find_tuned(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        field_boundary: &FieldBoundary,
        camera: Option<(&Camera, &Errors)>,
        detection: &GoalDetection,
    ) -> Goals {
        let step = if frame.height() > 320 { 4 } else { 2 };
        self.runs.segment(frame, colours, Colour::Yellow | Colour::Blue, Area::ALL.every(step));
        let bars = bars::gather(&self.runs);
        let size = Vec2::new(f32::from(frame.width()), f32::from(frame.height()));
        let search = PostSearch { size, runs: &self.runs, field_boundary, camera, detection };
        Goals { yellow: search.goal(GoalColour::Yellow, &bars), blue: search.goal(GoalColour::SkyBlue, &bars) }
    }
}

impl<const N: usize> Default for GoalFinder<N> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_post_has_a_width() {
        assert!(
            GoalDetection { min_post_width: 1.0, max_post_width: 1.0, ..GoalDetection::DEFAULT }.is_ordered().is_err()
        );
    }
}
