//! The goals: a yellow and a sky-blue one, each of two posts and a crossbar.
//!
//! Posts are upright bars that stand on the field and rise above its end. The crossbar at the top tells the left from
//! the right post when only one is seen. Cost at 320 × 240: segmentation 30 µs on every second row, then 5 µs.

mod posts;

use bica_field::{FIELD, GoalColour};
use glam::{Vec2, Vec3};

use self::posts::PostSearch;
use crate::bars;
use crate::colour::{Classify, Colour};
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::projection::Camera;
use crate::segment::{Area, Runs};

/// Which post of a goal, seen from the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PostSide {
    /// The left one.
    Left,
    /// The right one.
    Right,
    /// One of the two.
    Unknown,
}

/// A goal post in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Post {
    /// Which post it is.
    pub side: PostSide,
    /// The middle of its foot, pixels.
    pub base: Vec2,
    /// The middle of its top, pixels.
    pub top: Vec2,
    /// Its width, pixels.
    pub width: f32,
    /// Whether its foot is in the image.
    pub has_base: bool,
    /// Whether its top is in the image.
    pub has_top: bool,
}

impl Post {
    /// Where it stands, ground frame, m: by its foot, or by its width if the foot is not in the image.
    #[must_use]
    pub fn ground(&self, camera: &Camera) -> Option<Vec2> {
        if self.has_base {
            // The foot is seen where the post's front meets the ground, half its width before its middle.
            let front = camera.ground(self.base, 0.0)?;
            let eye = Vec3::from(camera.pose().translation).truncate();
            return Some(front + FIELD.post_radius() * (front - eye).normalize_or_zero());
        }
        let place = camera.place_by_radius(self.base, 0.5 * self.width, FIELD.post_radius())?;
        Some(place.truncate())
    }
}

/// What is seen of one goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Colour.
    pub colour: GoalColour,
    /// The post, or the left one of two.
    pub first: Post,
    /// The right post of two.
    pub second: Option<Post>,
    /// The top left corner of the box around posts and crossbar, pixels.
    pub min: Vec2,
    /// The bottom right corner, pixels.
    pub max: Vec2,
}

impl Goal {
    /// Whether both posts are seen from top to base.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        let whole = |post: &Post| post.has_base && post.has_top;
        whole(&self.first) && self.second.as_ref().is_some_and(whole)
    }

    /// The pixel in the middle of what is seen of the goal: between two posts, or where one stands.
    #[must_use]
    pub fn middle(&self) -> Vec2 {
        self.second.map_or(self.first.base, |second| 0.5 * (self.first.base + second.base))
    }

    /// Where the middle of the goal is, ground frame, m: between its posts; of one post with a known side 0.7 m
    /// beside it, at a right angle to the way there; else the post itself.
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

/// The goals of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goals {
    /// The yellow goal.
    pub yellow: Option<Goal>,
    /// The sky-blue goal.
    pub blue: Option<Goal>,
}

/// Finds goals; holds the memory for it: 8 bytes for each of `N` runs. `N` = 512 is plenty.
#[derive(Clone, Debug)]
pub struct GoalFinder<const N: usize> {
    runs: Runs<N>,
}

impl<const N: usize> GoalFinder<N> {
    /// A finder.
    #[must_use]
    pub const fn new() -> Self {
        Self { runs: Runs::new() }
    }

    /// Finds the goals of a frame. Only yellow and blue are asked for. With `camera`, bars that end below the horizon
    /// or are too thin or thick for their place are refused.
    pub fn find(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        field_boundary: &FieldBoundary,
        camera: Option<&Camera>,
    ) -> Goals {
        let step = if frame.height() > 320 { 4 } else { 2 };
        self.runs.segment(frame, colours, Colour::Yellow | Colour::Blue, Area::ALL.every(step));
        among(frame, &self.runs, field_boundary, camera)
    }

    /// How many runs of the last frame found no place.
    #[must_use]
    pub const fn dropped(&self) -> u32 {
        self.runs.dropped()
    }
}

impl<const N: usize> Default for GoalFinder<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// The goals among runs that were segmented with yellow and blue.
#[must_use]
pub fn among<const N: usize>(
    frame: &Frame<'_>,
    runs: &Runs<N>,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
) -> Goals {
    let bars = bars::gather(runs);
    let look = PostSearch {
        size: Vec2::new(f32::from(frame.width()), f32::from(frame.height())),
        runs,
        field_boundary,
        camera,
    };
    Goals { yellow: look.goal(GoalColour::Yellow, &bars), blue: look.goal(GoalColour::SkyBlue, &bars) }
}
