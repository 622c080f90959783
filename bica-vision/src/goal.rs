//! The goals: a yellow and a sky-blue one, each of two posts and a crossbar.
//!
//! Posts are upright bars that stand on the field and rise above its end. The crossbar at the top tells the left from
//! the right post when only one is seen. Cost at 320 × 240: segmentation 30 µs on every second row, then 5 µs.

use glam::Vec2;
use heapless::Vec;

use crate::bars::{self, BARS, Bar};
use crate::colour::{Classify, Colour};
use crate::field_end::FieldEnd;
use crate::frame::Frame;
use crate::projection::Camera;
use crate::segment::{Area, Run, Runs};

/// Distance of the middles of a goal's posts, m (rules of 2009).
pub const POST_DISTANCE: f32 = 1.4;
/// Diameter of a post, m.
pub const POST_WIDTH: f32 = 0.1;
/// Height of a goal, m.
pub const HEIGHT: f32 = 0.8;

/// An error of the camera's pitch that checks of the geometry forgive, rad.
const PITCH_ERROR: f32 = 0.06;

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
            return camera.ground(self.base, 0.0);
        }
        let place = camera.place_by_radius(self.base, 0.5 * self.width, 0.5 * POST_WIDTH)?;
        Some(place.truncate())
    }
}

/// What is seen of one goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// [`Colour::Yellow`] or [`Colour::Blue`].
    pub colour: Colour,
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
            PostSide::Left => first - 0.5 * POST_DISTANCE * left,
            PostSide::Right => first + 0.5 * POST_DISTANCE * left,
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

/// Finds goals; holds the memory for it: 8 bytes for each of `N` runs. `N` = 1024 is plenty.
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
        field_end: &FieldEnd,
        camera: Option<&Camera>,
    ) -> Goals {
        let step = if frame.height() > 320 { 4 } else { 2 };
        self.runs.segment(frame, colours, Colour::Yellow | Colour::Blue, Area::ALL.every(step));
        among(frame, &self.runs, field_end, camera)
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
    field_end: &FieldEnd,
    camera: Option<&Camera>,
) -> Goals {
    let bars = bars::gather(runs);
    let look = Look { size: Vec2::new(f32::from(frame.width()), f32::from(frame.height())), runs, field_end, camera };
    Goals { yellow: look.goal(Colour::Yellow, &bars), blue: look.goal(Colour::Blue, &bars) }
}

struct Look<'a, const N: usize> {
    size: Vec2,
    runs: &'a Runs<N>,
    field_end: &'a FieldEnd,
    camera: Option<&'a Camera>,
}

impl<const N: usize> Look<'_, N> {
    fn goal(&self, colour: Colour, bars: &[Bar]) -> Option<Goal> {
        let own = bars.iter().filter(|bar| bar.colour == colour && self.is_post(bar));
        let posts: Vec<Post, BARS> = own.map(|bar| self.post(bar)).collect();
        let (mut first, mut second) = (posts.iter().copied().max_by(|a, b| area(a).total_cmp(&area(b)))?, None);
        if let Some((left, right)) = best_pair(&posts) {
            first = Post { side: PostSide::Left, ..left };
            second = Some(Post { side: PostSide::Right, ..right });
        }
        let (min, max) = self.bounds(colour, first, second);
        Some(Goal { colour, first, second, min, max })
    }

    fn is_post(&self, bar: &Bar) -> bool {
        let height = bar.height();
        let dense = f32::from(bar.rows * self.runs.step()) >= 0.7 * height;
        let upright = height >= 1.5 * bar.width && (bar.top.x - bar.bottom.x).abs() <= 0.7 * height;
        dense && upright && height >= 0.05 * self.size.y && self.stands_on_field(bar) && self.fits_camera(bar)
    }

    fn is_at_top(&self, row: f32) -> bool {
        row < 2.0 * f32::from(self.runs.step())
    }

    fn is_at_bottom(&self, row: f32) -> bool {
        row > self.size.y - 1.0 - 2.0 * f32::from(self.runs.step())
    }

    /// Its foot is on the field and its top above the end of it.
    fn stands_on_field(&self, bar: &Bar) -> bool {
        let Some(end) = self.field_end.row_at(bar.bottom.x) else {
            return self.is_at_bottom(bar.bottom.y) && self.is_at_top(bar.top.y);
        };
        let margin = 2.0 + 0.1 * bar.height();
        let rises = bar.top.y < end - 0.25 * bar.height() || self.is_at_top(bar.top.y);
        bar.bottom.y >= end - margin && rises
    }

    /// It reaches the horizon, as it is higher than the robot, and is as thick as a post there.
    fn fits_camera(&self, bar: &Bar) -> bool {
        let Some(camera) = self.camera else { return true };
        let slack = PITCH_ERROR * camera.intrinsics().focal.y;
        let reaches = camera.horizon(bar.top.x).is_some_and(|row| bar.top.y <= row + slack);
        (reaches || self.is_at_top(bar.top.y)) && (self.is_at_bottom(bar.bottom.y) || is_of_width(camera, bar, slack))
    }

    fn post(&self, bar: &Bar) -> Post {
        Post {
            side: self.side(bar),
            base: bar.bottom,
            top: bar.top,
            width: bar.width,
            has_base: !self.is_at_bottom(bar.bottom.y),
            has_top: !self.is_at_top(bar.top.y),
        }
    }

    /// The runs of a crossbar that may start at the top of a bar.
    fn crossing(&self, bar: &Bar) -> impl Iterator<Item = &Run> {
        let rows = bar.top.y - 0.15 * bar.height() - 3.0..=bar.top.y + 0.1 * bar.height();
        let (x, half, colour) = (bar.top.x, 0.5 * bar.width + 2.0, bar.colour);
        let close = move |run: &&Run| f32::from(run.start) <= x + half && f32::from(run.end) >= x - half;
        let runs = self.runs.as_slice().iter();
        runs.filter(move |run| run.colour == colour && rows.contains(&f32::from(run.row))).filter(close)
    }

    fn side(&self, bar: &Bar) -> PostSide {
        let half = 0.5 * bar.width;
        let to_left = self.crossing(bar).map(|run| bar.top.x - half - f32::from(run.start)).fold(0.0, f32::max);
        let to_right = self.crossing(bar).map(|run| f32::from(run.end) - bar.top.x - half).fold(0.0, f32::max);
        let enough = bar.width + 2.0;
        if to_right > enough && to_right > 2.0 * to_left {
            PostSide::Left
        } else if to_left > enough && to_left > 2.0 * to_right {
            PostSide::Right
        } else {
            PostSide::Unknown
        }
    }

    /// The box around the posts and what hangs on to their tops.
    fn bounds(&self, colour: Colour, first: Post, second: Option<Post>) -> (Vec2, Vec2) {
        let (mut min, mut max) = (Vec2::MAX, Vec2::MIN);
        for post in [Some(first), second].into_iter().flatten() {
            let half = Vec2::new(0.5 * post.width, 0.0);
            min = min.min(post.base - half).min(post.top - half);
            max = max.max(post.base + half).max(post.top + half);
        }
        let rows = min.y - 0.15 * (max.y - min.y)..=min.y + 0.25 * (max.y - min.y);
        let bar = self.runs.as_slice().iter().filter(|r| r.colour == colour && rows.contains(&f32::from(r.row)));
        let (mut low, mut high) = (min, max);
        // Upwards along a crossbar that rises to one side, then downwards along one that falls.
        for run in bar.clone().rev().chain(bar) {
            if f32::from(run.start) <= high.x + 2.0 && f32::from(run.end) >= low.x - 2.0 {
                low = low.min(Vec2::new(f32::from(run.start), f32::from(run.row)));
                high.x = high.x.max(f32::from(run.end - 1));
            }
        }
        (low, high.max(max))
    }
}

fn area(post: &Post) -> f32 {
    (post.base.y - post.top.y) * post.width
}

/// Whether a post at the bar's foot would be as thick as the bar, give or take an error in the camera's pitch.
fn is_of_width(camera: &Camera, bar: &Bar, slack: f32) -> bool {
    let expected = |dy: f32| {
        let place = camera.ground(bar.bottom + Vec2::new(0.0, dy), 0.0)?;
        camera.sphere_radius(place.extend(0.5 * POST_WIDTH), 0.5 * POST_WIDTH).map(|radius| 2.0 * radius)
    };
    let Some(thickest) = expected(slack) else { return false };
    let thinnest = expected(-slack).unwrap_or(0.0);
    (0.6 * thinnest - 2.0..=1.6 * thickest + 4.0).contains(&bar.width)
}

/// The two posts, left and right, that make the largest plausible goal.
fn best_pair(posts: &[Post]) -> Option<(Post, Post)> {
    let pairs = posts.iter().flat_map(|a| posts.iter().map(move |b| (*a, *b)));
    pairs.filter(|(a, b)| is_goal(a, b)).max_by(|p, q| (area(&p.0) + area(&p.1)).total_cmp(&(area(&q.0) + area(&q.1))))
}

fn is_goal(left: &Post, right: &Post) -> bool {
    let (low, high) = (left.width.min(right.width), left.width.max(right.width));
    let heights = [left, right].map(|post| post.base.y - post.top.y);
    let height = heights[0].max(heights[1]);
    let apart = right.base.x - left.base.x;
    let whole = left.has_base && left.has_top && right.has_base && right.has_top;
    let shape = if whole { 0.4 * height..=2.6 * height } else { 1.5 * high..=f32::MAX };
    left.side != PostSide::Right
        && right.side != PostSide::Left
        && high <= 2.0 * low + 2.0
        && shape.contains(&apart)
        && (!whole || heights[0].min(heights[1]) >= 0.45 * height)
}
