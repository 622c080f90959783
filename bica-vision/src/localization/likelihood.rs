//! Observation likelihood of a pose.
//!
//! Terms that depend only on the image are computed once. Each particle then costs a rotation of each sighting and a
//! few multiplications. Directions are compared by unit vectors: except in the tail of the kernel, the chord between
//! two vectors approximates their angle.

use core::f32::consts::{FRAC_PI_4, LN_2};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use heapless::Vec;

use super::approximate::{direction, exp2, log2, sqrt};
use super::map::{HALF, least, line_distance_squared};
use super::{POINTS, POSTS, PostSighting, SightingUse, Sightings};
use crate::crossings::CROSSINGS;
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
/// Shortest distance between a particle and a post, m: it keeps divisions by it finite.
const SHORTEST: f32 = 0.01;

/// Sightings of an image, prepared for the comparison with many poses.
pub(super) struct Observation {
    points: Vec<Position, POINTS>,
    /// Weight of a point's logarithmic likelihood.
    share: f32,
    crossings: Vec<SeenCrossing, CROSSINGS>,
    circle: Option<Position>,
    posts: Vec<SeenPost, POSTS>,
    temper: f32,
}

/// Position on the ground, ground frame.
struct Position {
    place: Vec2,
    /// Inverse of its variance, 1/m².
    precision: f32,
}

struct SeenCrossing {
    position: Position,
    /// Symmetry axis, ground frame.
    axis: Vec2,
    kind: CrossingKind,
    /// Crossings of this kind in the quarter of the field with positive coordinates; the others are their mirror images.
    known: [KnownCrossing; 2],
}

/// Position and symmetry axis in the field frame.
#[derive(Clone, Copy)]
struct KnownCrossing {
    position: Vec2,
    axis: Vec2,
}

struct SeenPost {
    direction: Vec2,
    distance: f32,
    /// Posts of the field that match the sighting, field frame.
    known: [Vec2; 2],
    /// Inverse of the variance of the direction, 1/rad².
    aside: f32,
    measure: DistanceMeasure,
}

/// Source of the distance of a post.
enum DistanceMeasure {
    /// Angle of its foot below the horizon, with the inverse of its variance, 1/rad².
    Foot(f32),
    Width,
}

impl Observation {
    pub(super) fn new(sightings: &Sightings, tuning: &SightingUse) -> Self {
        let position = |place: Vec2| Position { place, precision: square(1.0 / deviation(place, tuning)) };
        let crossing = |(kind, seen): &(CrossingKind, Pose2)| SeenCrossing {
            position: position(seen.position),
            axis: axis(*kind, seen.heading),
            kind: *kind,
            known: known(*kind),
        };
        Self {
            points: sightings.points.iter().map(|point| position(*point)).collect(),
            share: (INDEPENDENT / sightings.points.len().max(1) as f32).min(ALONE),
            crossings: sightings.crossings.iter().map(crossing).collect(),
            circle: sightings.circle.map(|circle| position(circle.centre)),
            posts: sightings.posts.iter().map(|post| SeenPost::new(post, tuning)).collect(),
            temper: tuning.temper,
        }
    }

    /// Likelihood of all sightings, not normalized, above 0 and at most 1.
    pub(super) fn likelihood(&self, pose: &Pose2) -> f32 {
        exp2(self.octaves(pose))
    }

    /// Binary logarithm of the likelihood.
    pub(super) fn octaves(&self, pose: &Pose2) -> f32 {
        let (position, ahead) = (pose.position, direction(pose.heading));
        let points: f32 = self.points.iter().map(|point| point.on_line(position, ahead)).product();
        let crossings: f32 = self.crossings.iter().map(|seen| seen.likelihood(position, ahead)).product();
        let posts: f32 = self.posts.iter().map(|post| post.likelihood(position, ahead)).product();
        let circle = self.circle.as_ref().map_or(1.0, |circle| {
            let off = (position + ahead.rotate(circle.place)).length_squared();
            with_outliers(CROSSING_FLOOR, off * circle.precision)
        });
        self.temper * (self.share * log2(points) + log2(crossings * posts * circle))
    }

    /// Effective number of sightings in the likelihood, at least 1.
    pub(super) fn count(&self) -> f32 {
        let points = self.share * self.points.len() as f32;
        let others = self.crossings.len() + self.posts.len() + usize::from(self.circle.is_some());
        (self.temper * (points + others as f32)).max(1.0)
    }
}

impl Position {
    fn on_line(&self, position: Vec2, ahead: Vec2) -> f32 {
        let off = line_distance_squared(position + ahead.rotate(self.place));
        with_outliers(POINT_FLOOR, off * self.precision)
    }
}

impl SeenCrossing {
    fn likelihood(&self, position: Vec2, ahead: Vec2) -> f32 {
        let (at, axis) = (position + ahead.rotate(self.position.place), ahead.rotate(self.axis));
        // The mirror image in the quarter with positive coordinates.
        let (at, axis) = (at.abs(), axis * at.signum());
        let square = |known: &KnownCrossing| {
            let alike = if self.kind == CrossingKind::X { axis.abs().max_element() } else { axis.dot(known.axis) };
            at.distance_squared(known.position) * self.position.precision + 2.0 * (1.0 - alike) / (TURNED * TURNED)
        };
        let [one, other] = &self.known;
        with_outliers(CROSSING_FLOOR, least(square(one), square(other)))
    }
}

impl SeenPost {
    fn new(post: &PostSighting, tuning: &SightingUse) -> Self {
        let [left, right] = FIELD.goal_posts(post.attacked);
        let known = match post.side {
            PostSide::Left => [left; 2],
            PostSide::Right => [right; 2],
            PostSide::Unknown => [left, right],
        };
        let distance = post.at.length().max(SHORTEST);
        let measure = if post.has_base {
            DistanceMeasure::Foot(square(1.0 / tuning.elevation_error))
        } else {
            DistanceMeasure::Width
        };
        let aside = square(1.0 / tuning.azimuth_error);
        Self { direction: post.at / distance, distance, known, aside, measure }
    }

    fn likelihood(&self, position: Vec2, ahead: Vec2) -> f32 {
        let seen = ahead.rotate(self.direction);
        let square = |known: &Vec2| {
            let way = *known - position;
            let distance = sqrt(way.length_squared()).max(SHORTEST);
            let aside = 2.0 * (1.0 - seen.dot(way) / distance);
            aside * self.aside + self.away(distance)
        };
        let [one, other] = &self.known;
        with_outliers(POST_FLOOR, least(square(one), square(other)))
    }

    /// Square of the error of the distance, in standard deviations.
    fn away(&self, expected: f32) -> f32 {
        let off = expected - self.distance;
        match self.measure {
            // The tangent of the difference of the angles.
            DistanceMeasure::Foot(precision) => square(EYE * off / (expected * self.distance + EYE * EYE)) * precision,
            // For distances of a similar size the logarithm of their ratio.
            DistanceMeasure::Width => square(off / (LN_2 * BY_WIDTH)) / (expected * self.distance),
        }
    }
}

/// Symmetry axis of a crossing with a heading as in [`bica_field::Crossing`].
fn axis(kind: CrossingKind, heading: f32) -> Vec2 {
    direction(wrap(if kind == CrossingKind::L { heading + FRAC_PI_4 } else { heading }))
}

/// Crossings of a kind in the quarter of the field with positive coordinates.
fn known(kind: CrossingKind) -> [KnownCrossing; 2] {
    let mut all = HALF
        .iter()
        .filter(|known| known.kind == kind && known.position.y > 0.0)
        .map(|known| KnownCrossing { position: known.position, axis: axis(kind, known.heading) });
    let first = all.next().unwrap_or(KnownCrossing { position: Vec2::INFINITY, axis: Vec2::X });
    [first, all.next().unwrap_or(first)]
}

/// Cauchy kernel above a floor: 1 at 0, with a heavy tail that is robust to outliers. `square` is the square of an error in
/// standard deviations.
fn with_outliers(floor: f32, square: f32) -> f32 {
    floor + (1.0 - floor) / (1.0 + square)
}

/// Standard deviation of a ground position, m.
fn deviation(place: Vec2, tuning: &SightingUse) -> f32 {
    CLOSE + tuning.elevation_error * (place.length_squared() + EYE * EYE) / EYE
}

const fn square(value: f32) -> f32 {
    value * value
}

#[cfg(test)]
mod tests {
    use super::super::random::Random;
    use bica_core::Params;

    use super::*;
    use crate::centre_circle::CentreCircle;
    use crate::localization::map;

    /// The same model with angles, all lines and crossings, and a mathematical library.
    fn reference(pose: &Pose2, sightings: &Sightings, tuning: &SightingUse) -> f32 {
        let off = |from: f32, place: Vec2| square(from / deviation(place, tuning));
        let point = |at: &Vec2| with_outliers(POINT_FLOOR, off(FIELD.line_distance(pose.place(*at)), *at));
        let points: f32 = sightings.points.iter().map(point).product();
        let share = (INDEPENDENT / sightings.points.len().max(1) as f32).min(ALONE);
        let crossing = |(kind, seen): &(CrossingKind, Pose2)| {
            let (place, heading) = (pose.place(seen.position), pose.heading + seen.heading);
            let square = map::crossings(*kind).flat_map(|known| {
                let turns = if *kind == CrossingKind::X { 4_u8 } else { 1 };
                let quarters = (0..turns).map(|quarter| 2.0 * FRAC_PI_4 * f32::from(quarter));
                let turned = quarters.map(move |quarter| wrap(heading - known.heading - quarter) / TURNED);
                turned.map(move |turned| off(known.position.distance(place), seen.position) + turned * turned)
            });
            with_outliers(CROSSING_FLOOR, square.fold(f32::INFINITY, f32::min))
        };
        let crossings: f32 = sightings.crossings.iter().map(crossing).product();
        let angle = |at: Vec2| libm::atan2f(at.y, at.x);
        let depth = |at: Vec2| libm::atan2f(EYE, at.length());
        let post = |post: &PostSighting| {
            let [left, right] = FIELD.goal_posts(post.attacked).map(|known| {
                let expected = pose.locate(known);
                let aside = wrap(angle(post.at) - angle(expected)) / tuning.azimuth_error;
                let away = if post.has_base {
                    (depth(post.at) - depth(expected)) / tuning.elevation_error
                } else {
                    libm::log2f(post.at.length() / expected.length()) / BY_WIDTH
                };
                with_outliers(POST_FLOOR, aside * aside + away * away)
            });
            match post.side {
                PostSide::Left => left,
                PostSide::Right => right,
                PostSide::Unknown => left.max(right),
            }
        };
        let posts: f32 = sightings.posts.iter().map(post).product();
        let circle = sightings.circle.map_or(1.0, |circle| {
            with_outliers(CROSSING_FLOOR, off(pose.place(circle.centre).length(), circle.centre))
        });
        libm::powf(libm::powf(points, share) * crossings * posts * circle, tuning.temper)
    }

    fn somewhere(random: &mut Random) -> Pose2 {
        Pose2::new(random.within(3.7), random.within(2.7), random.within(core::f32::consts::PI))
    }

    /// Whether a robot can stand at a pose.
    fn is_beside_no_post(pose: &Pose2) -> bool {
        let mut posts = [true, false].into_iter().flat_map(|attacked| FIELD.goal_posts(attacked));
        posts.all(|post| post.distance(pose.position) > 0.3)
    }

    /// Sightings with small errors from a pose.
    fn seen_from(pose: &Pose2, random: &mut Random) -> Sightings {
        let mut sightings = Sightings::default();
        for _ in 0..random.below(POINTS) {
            let on_line = Vec2::new(random.within(3.0), 2.0) + 0.05 * random.normal();
            sightings.points.extend([pose.locate(on_line)]);
        }
        for kind in [CrossingKind::L, CrossingKind::T, CrossingKind::X] {
            let chosen = random.below(map::count(kind));
            let known = map::crossings(kind).nth(chosen).expect("below the number of crossings");
            let seen = pose.inverse() * known;
            sightings.crossings.extend([(kind, Pose2 { heading: seen.heading + 0.1 * random.normal(), ..seen })]);
        }
        for side in [PostSide::Left, PostSide::Right, PostSide::Unknown] {
            let (attacked, has_base) = (random.unit() < 0.5, random.unit() < 0.5);
            let at = pose.locate(FIELD.goal_posts(attacked)[usize::from(side == PostSide::Right)]);
            sightings.posts.extend([PostSighting { at: at * (1.0 + 0.1 * random.normal()), side, attacked, has_base }]);
        }
        sightings.circle = Some(CentreCircle { centre: pose.locate(Vec2::ZERO), halfway: None });
        sightings
    }

    #[test]
    fn likelihood_is_that_of_model_with_angles() {
        let (mut random, tuning) = (Random::new(5), SightingUse::DEFAULT);
        let mut likely = 0;
        for _ in 0..5000 {
            let truth = somewhere(&mut random);
            let near = Pose2 {
                position: truth.position + 0.3 * Vec2::new(random.normal(), random.normal()),
                heading: truth.heading + 0.2 * random.normal(),
            };
            let sightings = seen_from(&truth, &mut random);
            let observation = Observation::new(&sightings, &tuning);
            for pose in [truth, near, somewhere(&mut random)].into_iter().filter(is_beside_no_post) {
                let (found, exact) = (observation.likelihood(&pose), reference(&pose, &sightings, &tuning));
                let off = libm::fabsf(libm::log2f(found / exact));
                assert!(off < 0.02 - 0.1 * libm::log2f(exact), "{found} instead of {exact} at {pose:?}: {sightings:?}");
                likely += u32::from(exact > 0.3);
            }
        }
        assert!(likely > 3000, "only {likely} of the poses are likely");
    }
}
