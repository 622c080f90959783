//! Scores of ball, goal posts and other robots.

use std::f32::consts::PI;

use bica_field::FIELD;
use bica_sim::PixelLabel;
use bica_vision::goal::{Goal, Post};
use bica_vision::pipeline::Detections;
use bica_vision::robots::Robot;
use glam::{Vec2, Vec3};

use super::FAR;
use super::score::Score;
use super::truth::{SIZE, Truth};

/// Minimum visible fraction of a ball for it to be due.
const BALL_PART: f32 = 0.5;
/// Minimum visible fraction of a post, and its minimum height, px, for it to be due.
const POST_PART: f32 = 0.5;
const POST_LEAST: f32 = 16.0;
/// Maximum distance of due robots, and maximum distance of a detection from the true position, m.
const ROBOTS_NEAR: f32 = 0.5;
const ROBOT_ERROR: f32 = 0.35;
/// Minimum fraction of a robot's box that shows a robot, percent.
const ROBOT_PART: usize = 20;

/// Scores the ball: due if half of it is visible. The error is relative to its distance.
pub(super) fn ball(score: &mut Score, seen: &Detections, truth: &Truth) {
    let place = truth.pose.locate(truth.ball);
    let at = truth.camera.pixel(place.extend(FIELD.ball_radius()));
    let expected = at.zip(truth.camera.sphere_radius(place.extend(FIELD.ball_radius()), FIELD.ball_radius()));
    let is_there = |ball: &bica_vision::ball::Ball| {
        expected.is_some_and(|(at, radius)| ball.centre.distance(at) < (0.5 * radius).max(3.0))
    };
    let hit = seen.ball.filter(is_there);
    if seen.ball.is_some() {
        score.seen(hit.is_some());
    }
    let part = expected.map_or(0.0, |(_, radius)| truth.area(PixelLabel::Ball) as f32 / (PI * radius * radius));
    if part < BALL_PART || place.length() > FAR {
        return;
    }
    score.due(hit.is_some());
    if let Some(ground) = hit.and_then(|ball| ball.ground(&truth.camera, FIELD.ball_radius())) {
        score.error(100.0 * ground.distance(place) / place.length());
    }
}

/// Scores posts: due at any distance if at least half of the post is visible. The error is relative to the distance; it
/// is computed only for posts with a visible foot.
pub(super) fn posts(score: &mut Score, seen: &Detections, truth: &Truth) {
    let goals = [(true, seen.goals.yellow), (false, seen.goals.blue)];
    for (yellow, goal) in goals {
        let found: Vec<Post> = goal.iter().flat_map(posts_of).collect();
        let known = FIELD.goal_posts(yellow == truth.attacks_yellow);
        for post in &found {
            score.seen(known.iter().any(|known| is_at(post, *known, truth)));
        }
        for known in known {
            let hit = found.iter().find(|post| is_at(post, known, truth));
            if !is_post_due(known, truth) {
                continue;
            }
            score.due(hit.is_some());
            let place = truth.pose.locate(known);
            if let Some(ground) = hit.filter(|post| post.has_base).and_then(|post| post.ground(&truth.camera)) {
                score.error(100.0 * ground.distance(place) / place.length());
            }
        }
    }
}

fn posts_of(goal: &Goal) -> impl Iterator<Item = Post> + use<> {
    [Some(goal.first), goal.second].into_iter().flatten()
}

/// Returns whether a detected post is in the column of a true one.
fn is_at(post: &Post, known: Vec2, truth: &Truth) -> bool {
    let ends = truth.pixel(known.extend(0.0)).zip(truth.pixel(known.extend(FIELD.goal_height())));
    ends.is_some_and(|(foot, top)| {
        let x = foot.x + (top.x - foot.x) * (post.base.y - foot.y) / (top.y - foot.y);
        (post.base.x - x).abs() < (0.3 * post.width).max(4.0)
    })
}

fn is_post_due(known: Vec2, truth: &Truth) -> bool {
    let points = (1..20_u8).map(|step| known.extend(FIELD.goal_height() * f32::from(step) / 20.0));
    let shown: Vec<Vec3> = points.filter(|point| truth.shows(*point, PixelLabel::Goal)).collect();
    let rows = |point: &Vec3| truth.pixel(*point).map_or(0.0, |pixel| pixel.y);
    let high = shown.first().map_or(0.0, rows) - shown.last().map_or(0.0, rows);
    shown.len() as f32 >= POST_PART * 19.0 && high >= POST_LEAST
}

/// Scores robots: due if both legs are visible down to the ground. The near edge is 0.1 m closer than the centre.
pub(super) fn robots(score: &mut Score, seen: &Detections, truth: &Truth) {
    for robot in &seen.robots {
        score.seen(is_robot(robot, truth));
    }
    let found = seen.robots.iter().filter_map(|robot| Some(truth.pose.place(robot.ground(&truth.camera)?)));
    let found: Vec<Vec2> = found.collect();
    for (index, other) in truth.others.iter().enumerate() {
        let distance = truth.distance(other.position);
        if !(ROBOTS_NEAR..FAR).contains(&distance) || !is_robot_due(index, other.position, truth) {
            continue;
        }
        let nearest = found.iter().map(|place| place.distance(other.position)).reduce(f32::min);
        let hit = nearest.filter(|off| *off < ROBOT_ERROR);
        score.due(hit.is_some());
        score.error(hit.map(|off| 100.0 * (off - 0.1).abs()));
    }
}

/// Returns whether a sufficient part of a box shows another robot, and whether its base agrees if it is visible and near.
fn is_robot(robot: &Robot, truth: &Truth) -> bool {
    let at = |u: f32, v: f32| truth.thing(robot.min + Vec2::new(u, v) * (robot.max - robot.min));
    let grid = (0..100_u8).map(|i| (0.05 + 0.1 * f32::from(i % 10), 0.05 + 0.1 * f32::from(i / 10)));
    let shown = grid.filter(|(u, v)| matches!(at(*u, *v), Some(PixelLabel::OtherRobot(_)))).count();
    let base = robot.ground(&truth.camera).filter(|base| base.length() <= FAR).map(|base| truth.pose.place(base));
    let is_base =
        base.is_none_or(|base| truth.others.iter().any(|other| other.position.distance(base) < ROBOT_ERROR + 0.1));
    shown >= ROBOT_PART && is_base
}

fn is_robot_due(index: usize, place: Vec2, truth: &Truth) -> bool {
    let toward = (truth.pose.position - place).normalize_or_zero();
    let feet = [-0.05, 0.05].map(|side| place + 0.04 * toward + side * toward.perp());
    let is_inside = |foot: &Vec2| {
        let pixel = truth.pixel(foot.extend(0.0));
        pixel.is_some_and(|at| (4.0..SIZE.0 as f32 - 4.0).contains(&at.x) && at.y < SIZE.1 as f32 - 4.0)
    };
    feet.iter().all(|foot| {
        is_inside(foot) && [0.03, 0.1, 0.2].iter().all(|z| truth.shows(foot.extend(*z), PixelLabel::OtherRobot(index)))
    })
}
