//! Selection of posts among bars, and of goals among posts.

use core::ops::RangeInclusive;

use bica_field::{FIELD, GoalColour};
use glam::Vec2;
use heapless::Vec;

use super::{Goal, GoalDetection, Post, PostSide};
use crate::bars::{BARS, Bar};
use crate::colour::Colour;
use crate::field_boundary::FieldBoundary;
use crate::hypothesis;
use crate::projection::Camera;
use crate::segment::{Run, Runs};
use crate::uncertainty::Errors;

/// Inputs of the search in one frame.
pub(super) struct PostSearch<'a, const N: usize> {
    pub(super) size: Vec2,
    pub(super) runs: &'a Runs<N>,
    pub(super) field_boundary: &'a FieldBoundary,
    /// Camera, and the errors of its pose.
    pub(super) camera: Option<(&'a Camera, &'a Errors)>,
    pub(super) detection: &'a GoalDetection,
}

impl<const N: usize> PostSearch<'_, N> {
    pub(super) fn goal(&self, goal: GoalColour, bars: &[Bar]) -> Option<Goal> {
        let colour = Colour::of_goal(goal);
        let own = bars.iter().filter(|bar| bar.colour == colour && self.is_post(bar));
        let posts: Vec<Post, BARS> = own.map(|bar| self.post(bar)).collect();
        let (mut first, mut second) = (posts.iter().copied().max_by(|a, b| area(a).total_cmp(&area(b)))?, None);
        if let Some((left, right)) = best_pair(&posts) {
            first = Post { side: PostSide::Left, ..left };
            second = Some(Post { side: PostSide::Right, ..right });
        }
        let (min, max) = self.bounds(colour, first, second);
        Some(Goal { colour: goal, first, second, min, max })
    }

    fn is_post(&self, bar: &Bar) -> bool {
        let height = bar.height();
        let dense = f32::from(bar.rows * self.runs.step()) >= 0.5 * height;
        let least = if self.is_at_top(bar.top.y) { 0.5 } else { 1.5 };
        let upright = height >= least * bar.width && (bar.top.x - bar.bottom.x).abs() <= 0.7 * height;
        let high = height >= self.detection.min_post_height * self.size.y;
        dense && upright && high && self.stands_on_field(bar) && self.fits_camera(bar)
    }

    fn is_at_top(&self, row: f32) -> bool {
        row < 2.0 * f32::from(self.runs.step())
    }

    fn is_at_bottom(&self, row: f32) -> bool {
        row > self.size.y - 1.0 - 2.0 * f32::from(self.runs.step())
    }

    /// Whether the foot is on the field and the top above the field boundary.
    fn stands_on_field(&self, bar: &Bar) -> bool {
        let Some(end) = self.field_boundary.row_at(bar.bottom.x) else {
            return self.is_at_bottom(bar.bottom.y) && self.is_at_top(bar.top.y);
        };
        let margin = 2.0 + 0.1 * bar.height();
        let rises = bar.top.y < end - 0.25 * bar.height() || self.is_at_top(bar.top.y);
        bar.bottom.y >= end - margin && rises
    }

    /// Whether the bar reaches the horizon, as a post is higher than the camera, and has a post's width at its position.
    fn fits_camera(&self, bar: &Bar) -> bool {
        let Some((camera, errors)) = self.camera else { return true };
        let slack = self.detection.pitch_error * camera.intrinsics().focal.y;
        let reaches = camera.horizon(bar.top.x).is_some_and(|row| bar.top.y <= row + slack);
        let sees_foot = !self.is_at_bottom(bar.bottom.y);
        let sees_all = sees_foot && !self.is_at_top(bar.top.y);
        (reaches || self.is_at_top(bar.top.y))
            && (!sees_foot || is_of_width(camera, bar, slack, self.detection))
            && (!sees_all || hypothesis::is_as_high(camera, bar.bottom, bar.top, FIELD.goal_height(), errors))
    }

    fn post(&self, bar: &Bar) -> Post {
        // On average the bar ends half way to the next scanned row.
        let beyond = Vec2::new(0.0, 0.5 * f32::from(self.runs.step()));
        Post {
            side: self.side(bar),
            base: bar.bottom + beyond,
            top: bar.top - beyond,
            width: bar.width,
            has_base: !self.is_at_bottom(bar.bottom.y),
            has_top: !self.is_at_top(bar.top.y),
        }
    }

    /// Runs of a crossbar that may start at the top of a bar.
    fn crossing(&self, bar: &Bar) -> impl Iterator<Item = &Run> {
        let rows = bar.top.y - 0.15 * bar.height() - 3.0..=bar.top.y + 0.1 * bar.height();
        let (x, half, colour) = (bar.top.x, 0.5 * bar.width + 2.0, bar.colour);
        let close = move |run: &&Run| f32::from(run.start) <= x + half && f32::from(run.end) >= x - half;
        self.between(&rows).iter().filter(move |run| run.colour == colour).filter(close)
    }

    /// Runs of a range of rows.
    fn between(&self, rows: &RangeInclusive<f32>) -> &[Run] {
        let runs = self.runs.as_slice();
        let first = runs.partition_point(|run| f32::from(run.row) < *rows.start());
        let count = runs[first..].partition_point(|run| f32::from(run.row) <= *rows.end());
        &runs[first..first + count]
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

    /// Bounding box of the posts and of the crossbar runs connected to their tops.
    fn bounds(&self, colour: Colour, first: Post, second: Option<Post>) -> (Vec2, Vec2) {
        let (mut min, mut max) = (Vec2::MAX, Vec2::MIN);
        for post in [Some(first), second].into_iter().flatten() {
            let half = Vec2::new(0.5 * post.width, 0.0);
            min = min.min(post.base - half).min(post.top - half);
            max = max.max(post.base + half).max(post.top + half);
        }
        let rows = min.y - 0.15 * (max.y - min.y)..=min.y + 0.25 * (max.y - min.y);
        let bar = self.between(&rows).iter().filter(|run| run.colour == colour);
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

/// Whether the bar has the width of a post at its foot's position, within the error of the camera's pitch.
fn is_of_width(camera: &Camera, bar: &Bar, slack: f32, detection: &GoalDetection) -> bool {
    let expected = |dy: f32| {
        let place = camera.ground(bar.bottom + Vec2::new(0.0, dy), 0.0)?;
        camera.sphere_radius(place.extend(FIELD.post_radius()), FIELD.post_radius()).map(|radius| 2.0 * radius)
    };
    let Some(thickest) = expected(slack) else { return false };
    let thinnest = expected(-slack).unwrap_or(0.0);
    (detection.min_post_width * thinnest - 2.0..=detection.max_post_width * thickest + 4.0).contains(&bar.width)
}

/// Pair of posts, left and right, of the largest plausible goal.
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
        && high <= 3.5 * low + 2.0
        && shape.contains(&apart)
        && (!whole || heights[0].min(heights[1]) >= 0.3 * height)
}
