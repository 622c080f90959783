//! Observation likelihood of a pose.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use libm::{atan2f, powf};

use super::{LocalizerTuning, PostSighting, Sightings, map};
use crate::goal::PostSide;

/// Height of the camera, m: relates errors of its pitch to errors of distance.
const EYE: f32 = 0.48;
/// Standard deviation of a position at the robot's feet, m.
const CLOSE: f32 = 0.04;
/// Standard deviation of a distance derived from a post's width, in octaves.
const BY_WIDTH: f32 = 0.4;
/// Standard deviation of a crossing's heading, rad.
const TURNED: f32 = 0.15;
/// Outlier floor of the likelihood of a line point.
const POINT_FLOOR: f32 = 0.1;
/// Outlier floor of the likelihood of a crossing or circle.
const CROSSING_FLOOR: f32 = 0.2;
/// Outlier floor of the likelihood of a post.
const POST_FLOOR: f32 = 0.05;
/// Effective number of independent observations of all line points of an image.
const INDEPENDENT: f32 = 6.0;
/// Maximum weight of one line point: neighbouring points on a short line are not independent.
const ALONE: f32 = 0.3;

/// Likelihood of all sightings, not normalized, above 0 and at most 1.
pub(super) fn of(pose: &Pose2, sightings: &Sightings, tuning: &LocalizerTuning) -> f32 {
    let points: f32 = sightings.points.iter().map(|point| of_point(pose, *point, tuning)).product();
    let share = (INDEPENDENT / sightings.points.len().max(1) as f32).min(ALONE);
    let crossings: f32 =
        sightings.crossings.iter().map(|(kind, seen)| of_crossing(pose, *kind, seen, tuning)).product();
    let posts: f32 = sightings.posts.iter().map(|post| of_post(pose, post, tuning)).product();
    let circle = sightings.circle.map_or(1.0, |circle| {
        let off = pose.place(circle.centre).length() / deviation(circle.centre, tuning);
        CROSSING_FLOOR + (1.0 - CROSSING_FLOOR) * cauchy(off * off)
    });
    powf(powf(points, share) * crossings * posts * circle, tuning.temper)
}

/// Effective number of sightings in the likelihood, at least 1.
pub(super) fn count(sightings: &Sightings, temper: f32) -> f32 {
    let points = INDEPENDENT.min(ALONE * sightings.points.len() as f32);
    let others = sightings.crossings.len() + sightings.posts.len() + usize::from(sightings.circle.is_some());
    (temper * (points + others as f32)).max(1.0)
}

/// Cauchy kernel: 1 at 0, with a heavy tail that is robust to outliers.
fn cauchy(square: f32) -> f32 {
    1.0 / (1.0 + square)
}

/// Standard deviation of a ground position, m.
fn deviation(place: Vec2, tuning: &LocalizerTuning) -> f32 {
    let way = place.length();
    CLOSE + tuning.elevation_error * (way * way + EYE * EYE) / EYE
}

fn of_point(pose: &Pose2, point: Vec2, tuning: &LocalizerTuning) -> f32 {
    let off = FIELD.line_distance(pose.place(point)) / deviation(point, tuning);
    POINT_FLOOR + (1.0 - POINT_FLOOR) * cauchy(off * off)
}

fn of_crossing(pose: &Pose2, kind: CrossingKind, seen: &Pose2, tuning: &LocalizerTuning) -> f32 {
    let (place, heading) = (pose.place(seen.position), pose.heading + seen.heading);
    let deviation = deviation(seen.position, tuning);
    let best = map::crossings(kind).map(|known| {
        let off = known.position.distance(place) / deviation;
        let turned = wrap(heading - known.heading);
        let turned = if kind == CrossingKind::X { quarter(turned) } else { turned } / TURNED;
        cauchy(off * off + turned * turned)
    });
    CROSSING_FLOOR + (1.0 - CROSSING_FLOOR) * best.fold(0.0, f32::max)
}

/// Angle modulo a quarter turn, −π/4 to π/4.
fn quarter(angle: f32) -> f32 {
    let folded = angle - FRAC_PI_2 * libm::floorf(angle / FRAC_PI_2);
    if folded > FRAC_PI_4 { folded - FRAC_PI_2 } else { folded }
}

fn of_post(pose: &Pose2, post: &PostSighting, tuning: &LocalizerTuning) -> f32 {
    let [left, right] = FIELD.goal_posts(post.attacked).map(|known| fit(pose, known, post, tuning));
    let best = match post.side {
        PostSide::Left => left,
        PostSide::Right => right,
        PostSide::Unknown => left.max(right),
    };
    POST_FLOOR + (1.0 - POST_FLOOR) * best
}

/// Fit of a known post to a seen one: by its direction, and by the angle of its foot below the horizon.
fn fit(pose: &Pose2, known: Vec2, post: &PostSighting, tuning: &LocalizerTuning) -> f32 {
    let (expected, seen) = (pose.locate(known), post.at);
    let aside = wrap(atan2f(seen.y, seen.x) - atan2f(expected.y, expected.x)) / tuning.azimuth_error;
    let away = if post.has_base {
        (atan2f(EYE, seen.length()) - atan2f(EYE, expected.length())) / tuning.elevation_error
    } else {
        libm::log2f(seen.length() / expected.length()) / BY_WIDTH
    };
    cauchy(aside * aside + away * away)
}
