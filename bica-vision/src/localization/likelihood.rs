//! How well a pose explains what is seen.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use libm::{atan2f, powf};

use super::{PostSighting, Sightings, map};
use crate::goal::PostSide;

/// How high the camera is, m: what turns an error of its pitch into one of distance.
const EYE: f32 = 0.48;
/// Deviations of directions: to the side and downwards, rad.
const ASKEW: (f32, f32) = (0.04, 0.012);
/// Deviation of what is at the feet, m.
const CLOSE: f32 = 0.04;
/// Deviation of a distance that a post's width tells, doublings.
const BY_WIDTH: f32 = 0.4;
/// Deviation of a crossing's heading, rad.
const TURNED: f32 = 0.15;
/// What is left of the likelihood if a point, a crossing or circle, or a post is nowhere near: it was none.
const FLOOR: (f32, f32, f32) = (0.1, 0.2, 0.05);
/// All points of an image count as much as so many that knew nothing of each other.
const INDEPENDENT: f32 = 6.0;
/// A point counts at most as this part of one: its neighbours on a short line say the same.
const ALONE: f32 = 0.3;
/// Images follow each other so closely that they say nearly the same: each counts as this part of one.
const TEMPER: f32 = 0.5;

/// The likelihood of all sightings, not normalized, above 0 and at most 1.
pub(super) fn of(pose: &Pose2, sightings: &Sightings) -> f32 {
    let points: f32 = sightings.points.iter().map(|point| of_point(pose, *point)).product();
    let share = (INDEPENDENT / sightings.points.len().max(1) as f32).min(ALONE);
    let crossings: f32 = sightings.crossings.iter().map(|(kind, seen)| of_crossing(pose, *kind, seen)).product();
    let posts: f32 = sightings.posts.iter().map(|post| of_post(pose, post)).product();
    let circle = sightings.circle.map_or(1.0, |circle| {
        let off = pose.place(circle.centre).length() / deviation(circle.centre);
        FLOOR.1 + (1.0 - FLOOR.1) * falling(off * off)
    });
    powf(powf(points, share) * crossings * posts * circle, TEMPER)
}

/// How many sightings the likelihood is of, at least 1.
pub(super) fn count(sightings: &Sightings) -> f32 {
    let points = INDEPENDENT.min(ALONE * sightings.points.len() as f32);
    let others = sightings.crossings.len() + sightings.posts.len() + usize::from(sightings.circle.is_some());
    (TEMPER * (points + others as f32)).max(1.0)
}

/// 1 at 0 and flat beyond: Cauchy's bell is kind to outliers.
fn falling(square: f32) -> f32 {
    1.0 / (1.0 + square)
}

/// The deviation of a place on the ground, m.
fn deviation(place: Vec2) -> f32 {
    let way = place.length();
    CLOSE + ASKEW.1 * (way * way + EYE * EYE) / EYE
}

fn of_point(pose: &Pose2, point: Vec2) -> f32 {
    let off = FIELD.line_distance(pose.place(point)) / deviation(point);
    FLOOR.0 + (1.0 - FLOOR.0) * falling(off * off)
}

fn of_crossing(pose: &Pose2, kind: CrossingKind, seen: &Pose2) -> f32 {
    let (place, heading) = (pose.place(seen.position), pose.heading + seen.heading);
    let deviation = deviation(seen.position);
    let best = map::crossings(kind).map(|known| {
        let off = known.position.distance(place) / deviation;
        let turned = wrap(heading - known.heading);
        let turned = if kind == CrossingKind::X { quarter(turned) } else { turned } / TURNED;
        falling(off * off + turned * turned)
    });
    FLOOR.1 + (1.0 - FLOOR.1) * best.fold(0.0, f32::max)
}

/// An angle up to quarter turns, −π/4 to π/4.
fn quarter(angle: f32) -> f32 {
    let folded = angle - FRAC_PI_2 * libm::floorf(angle / FRAC_PI_2);
    if folded > FRAC_PI_4 { folded - FRAC_PI_2 } else { folded }
}

fn of_post(pose: &Pose2, post: &PostSighting) -> f32 {
    let [left, right] = FIELD.goal_posts(post.attacked).map(|known| fit(pose, known, post));
    let best = match post.side {
        PostSide::Left => left,
        PostSide::Right => right,
        PostSide::Unknown => left.max(right),
    };
    FLOOR.2 + (1.0 - FLOOR.2) * best
}

/// How well a post of the field is where one is seen: by its direction and by how far below the horizon its foot is.
fn fit(pose: &Pose2, known: Vec2, post: &PostSighting) -> f32 {
    let (expected, seen) = (pose.locate(known), post.at);
    let aside = wrap(atan2f(seen.y, seen.x) - atan2f(expected.y, expected.x)) / ASKEW.0;
    let away = if post.has_base {
        (atan2f(EYE, seen.length()) - atan2f(EYE, expected.length())) / ASKEW.1
    } else {
        libm::log2f(seen.length() / expected.length()) / BY_WIDTH
    };
    falling(aside * aside + away * away)
}
