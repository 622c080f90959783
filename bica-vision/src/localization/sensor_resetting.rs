//! Sensor resetting: poses drawn from the observation.

use core::f32::consts::{FRAC_PI_2, PI};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::atan2f;

use super::random::Random;
use super::{PostSighting, Sightings, map, pose_of};
use crate::goal::PostSide;

/// Standard deviation of a drawn position close to the observed object, m.
const SPREAD: f32 = 0.03;
/// Growth of this standard deviation per metre of distance.
const SPREAD_PER_METRE: f32 = 0.03;
/// Standard deviation of a drawn heading, rad.
const HEADING_SPREAD: f32 = 0.03;
/// Tolerance on the distance between two posts of a goal, m for each metre of their distance.
const WIDTH_ERROR: f32 = 0.15;

/// Uniformly distributed pose within the field lines.
pub(super) fn anywhere(random: &mut Random) -> Pose2 {
    Pose2::new(random.within(FIELD.field_corner().x), random.within(FIELD.field_corner().y), random.within(PI))
}

/// Pose from which one of the sightings would look as observed; prefers the most informative ones.
pub(super) fn from(sightings: &Sightings, random: &mut Random) -> Pose2 {
    let crossings = &sightings.crossings;
    let from_lines = crossings.len() + usize::from(sightings.circle.is_some());
    let drawn = if !sightings.posts.is_empty() && (from_lines == 0 || random.unit() < 0.6) {
        from_posts(sightings, random)
    } else if from_lines > 0 && random.unit() < 0.9 {
        let index = random.below(from_lines);
        match crossings.get(index) {
            Some(&(kind, seen)) => Some((from_crossing(kind, seen, random), seen.position.length())),
            None => from_circle(sightings, random),
        }
    } else {
        None
    };
    match drawn.filter(|(pose, _)| pose.position.abs().cmple(FIELD.carpet_corner()).all()) {
        Some((pose, way)) => spread(pose, way, random),
        None => anywhere(random),
    }
}

fn spread(pose: Pose2, way: f32, random: &mut Random) -> Pose2 {
    let off = Vec2::new(random.normal(), random.normal()) * (SPREAD + SPREAD_PER_METRE * way);
    Pose2 { position: pose.position + off, heading: pose.heading + HEADING_SPREAD * random.normal() }
}

/// Pose, and the distance of the object that it was derived from.
type Drawn = Option<(Pose2, f32)>;

fn from_posts(sightings: &Sightings, random: &mut Random) -> Drawn {
    let posts = &sightings.posts;
    let post = posts.get(random.below(posts.len()))?;
    let (left, right) = match post.side {
        PostSide::Left => (Some(post), partner(posts, post, PostSide::Right)),
        _ => (partner(posts, post, PostSide::Left), Some(post)),
    };
    if let (Some(left), Some(right)) = (left, right)
        && post.side != PostSide::Unknown
    {
        let [known_left, known_right] = FIELD.goal_posts(post.attacked);
        let pose = pose_of(between(known_left, known_right), between(left.at, right.at));
        return Some((pose, left.at.length()));
    }
    let [left, right] = FIELD.goal_posts(post.attacked);
    let is_left = match post.side {
        PostSide::Left => true,
        PostSide::Right => false,
        PostSide::Unknown => random.unit() < 0.5,
    };
    let known = Pose2 { position: if is_left { left } else { right }, heading: random.within(PI) };
    Some((pose_of(known, Pose2 { position: post.at, heading: 0.0 }), post.at.length()))
}

fn partner<'a>(posts: &'a [PostSighting], post: &PostSighting, side: PostSide) -> Option<&'a PostSighting> {
    posts.iter().find(|other| {
        let width = other.at.distance(post.at);
        let error = 0.1 + WIDTH_ERROR * post.at.length();
        other.side == side && other.attacked == post.attacked && libm::fabsf(width - FIELD.goal_width()) < error
    })
}

/// Midpoint of two posts, with the heading from the right to the left one.
fn between(left: Vec2, right: Vec2) -> Pose2 {
    let across = left - right;
    Pose2 { position: 0.5 * (left + right), heading: atan2f(across.y, across.x) }
}

fn from_circle(sightings: &Sightings, random: &mut Random) -> Drawn {
    let circle = sightings.circle?;
    let seen_heading = circle.halfway.map_or_else(|| random.within(PI), |way| atan2f(way.y, way.x));
    let known = Pose2::new(0.0, 0.0, if random.unit() < 0.5 { FRAC_PI_2 } else { -FRAC_PI_2 });
    Some((pose_of(known, Pose2 { position: circle.centre, heading: seen_heading }), circle.centre.length()))
}

fn from_crossing(kind: CrossingKind, seen: Pose2, random: &mut Random) -> Pose2 {
    let chosen = random.below(map::count(kind));
    let mut known = map::crossings(kind).nth(chosen).unwrap_or(Pose2::ORIGIN);
    if kind == CrossingKind::X {
        known.heading += FRAC_PI_2 * random.below(4) as f32;
    }
    pose_of(known, seen)
}
