//! Sightings from the detections of an image.

use bica_field::GoalColour;
use glam::Vec2;
use heapless::Vec;

use super::{POINTS, POSTS, PostSighting, Sightings};
use crate::crossings::Crossing;
use crate::goal::{Goal, Goals, Post};
use crate::lines::Line;
use crate::markings::Markings;
use crate::projection::Camera;

/// Maximum distance of a crossing with a reliable heading, m.
const CROSSING_FARTHEST: f32 = 3.0;

impl Sightings {
    /// Sightings of one image: field markings and goals. `attacked` is the colour of the goal at positive x.
    #[must_use]
    pub fn of(markings: &Markings, goals: &Goals, attacked: GoalColour, camera: &Camera) -> Self {
        let near = |crossing: &Crossing| {
            let is_near = crossing.ground.position.length() < CROSSING_FARTHEST;
            is_near.then_some((crossing.kind, crossing.ground))
        };
        let goals = [goals.yellow, goals.blue].into_iter().flatten();
        let mut posts: Vec<PostSighting, POSTS> = Vec::new();
        for (goal, post) in goals.flat_map(|goal| posts_of(&goal).map(move |post| (goal.colour, post))) {
            let (side, attacked, has_base) = (post.side, goal == attacked, post.has_base);
            let sighting = post.ground(camera).map(|at| PostSighting { at, side, attacked, has_base });
            posts.extend(sighting.into_iter().take(POSTS - posts.len()));
        }
        Self {
            points: spread(&markings.lines),
            crossings: markings.crossings.iter().filter_map(near).collect(),
            circle: markings.circle,
            posts,
        }
    }
}

fn posts_of(goal: &Goal) -> impl Iterator<Item = Post> + use<> {
    [Some(goal.first), goal.second].into_iter().flatten()
}

/// Points on lines at equal distances.
fn spread(lines: &[Line]) -> Vec<Vec2, POINTS> {
    let length: f32 = lines.iter().map(Line::length).sum();
    let pitch = (length / POINTS as f32).max(0.1);
    let mut points = Vec::new();
    let mut rest = 0.5 * pitch;
    for line in lines {
        let length = line.length();
        while rest < length && !points.is_full() {
            points.extend([line.from.lerp(line.to, rest / length)]);
            rest += pitch;
        }
        rest -= length;
    }
    points
}
