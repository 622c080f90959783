//! Scores of field markings and the field boundary.

use std::f32::consts::TAU;

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use bica_sim::PixelLabel;
use bica_vision::lines::Line;
use bica_vision::localization::map;
use bica_vision::pipeline::Detections;
use glam::Vec2;

use super::FAR;
use super::score::Score;
use super::truth::{SIZE, Truth};

/// Length of the pieces into which lines are divided for counting, m.
const PIECE: f32 = 0.1;
/// Maximum distance of a detected line from a true piece, px.
const LINE_NEAR_PIXELS: f32 = 3.0;
/// Maximum distance of a detected piece from a true line, m.
const LINE_NEAR: f32 = 0.1;
/// Maximum distance of a detected crossing from a true one, m.
const CROSSING_NEAR: f32 = 0.2;
/// Maximum difference of their headings, rad.
const CROSSING_TURN: f32 = 0.3;
/// Length of the arms that must be visible for a crossing to be due, m.
const ARM: f32 = 0.2;
/// Minimum visible fraction of the circle for it to be due.
const CIRCLE_PART: f32 = 0.3;
/// Maximum distance of the detected centre from the true one, m.
const CIRCLE_NEAR: f32 = 0.2;
/// Maximum error of the field boundary, rows.
const END_NEAR: f32 = 3.0;

/// Straight lines of one half of the field.
const LINES: [(Vec2, Vec2); 7] = {
    let (c, p) = (FIELD.field_corner(), FIELD.penalty_area_corner());
    [
        (Vec2::new(0.0, c.y), c),
        (Vec2::new(0.0, -c.y), Vec2::new(c.x, -c.y)),
        (Vec2::new(c.x, -c.y), c),
        (Vec2::new(c.x, p.y), p),
        (Vec2::new(c.x, -p.y), Vec2::new(p.x, -p.y)),
        (Vec2::new(p.x, -p.y), p),
        (Vec2::ZERO, Vec2::new(0.0, c.y)),
    ]
};

/// Midpoints of all pieces of lines, field frame, m.
fn pieces() -> impl Iterator<Item = Vec2> {
    let straight = LINES.into_iter().flat_map(|(from, to)| {
        let count = (from.distance(to) / PIECE).round() as usize;
        (0..count).map(move |i| from.lerp(to, (i as f32 + 0.5) / count as f32))
    });
    let round = (0..(TAU * FIELD.centre_circle_radius() / PIECE) as usize / 2)
        .map(|i| FIELD.centre_circle_radius() * Vec2::from_angle(PIECE / FIELD.centre_circle_radius() * i as f32));
    straight.chain(round).flat_map(|at| [at, -at])
}

/// Returns whether a ground point is visible and at least 4 pixels inside the image.
fn is_seen(place: Vec2, truth: &Truth) -> bool {
    let inside = |at: Vec2| at.min(Vec2::new(SIZE.0 as f32, SIZE.1 as f32) - at).min_element() > 4.0;
    truth.shows(place.extend(0.0), PixelLabel::Background) && truth.pixel(place.extend(0.0)).is_some_and(inside)
}

/// Scores visible pieces of true lines (recall) and pieces of detected lines (precision).
pub(super) fn lines(score: &mut Score, seen: &Detections, truth: &Truth) {
    let pixels =
        |line: &Line| Some((truth.camera.pixel(line.from.extend(0.0))?, truth.camera.pixel(line.to.extend(0.0))?));
    let found: Vec<(Vec2, Vec2)> = seen.markings.lines.iter().filter_map(pixels).collect();
    for piece in pieces().filter(|piece| truth.distance(*piece) <= FAR && is_seen(*piece, truth)) {
        let at = truth.pixel(piece.extend(0.0));
        score.due(at.is_some_and(|at| found.iter().any(|(from, to)| distance(at, *from, *to) <= LINE_NEAR_PIXELS)));
    }
    for line in &seen.markings.lines {
        let count = (line.length() / PIECE).ceil();
        for index in 0..count as usize {
            let place = line.from.lerp(line.to, (index as f32 + 0.5) / count);
            if place.length() <= FAR {
                let off = line_distance(truth.pose.place(place));
                score.seen(off <= LINE_NEAR);
                score.error(100.0 * off);
            }
        }
    }
}

/// Distance of a point from the nearest true line, m.
fn line_distance(place: Vec2) -> f32 {
    let straight = LINES.iter().flat_map(|(from, to)| [(*from, *to), (-*from, -*to)]);
    let nearest = straight.map(|(from, to)| distance(place, from, to)).fold(f32::INFINITY, f32::min);
    let marks = [1.0, -1.0].map(|side| place.distance(Vec2::new(side * FIELD.penalty_mark(), 0.0)));
    nearest.min((place.length() - FIELD.centre_circle_radius()).abs()).min(marks[0]).min(marks[1])
}

fn distance(at: Vec2, from: Vec2, to: Vec2) -> f32 {
    let along = to - from;
    let share = ((at - from).dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
    at.distance(from + share * along)
}

/// Scores crossings: due if their arms are visible, right if kind, position and heading agree.
pub(super) fn crossings(score: &mut Score, seen: &Detections, truth: &Truth) {
    let found = seen.markings.crossings.iter().map(|crossing| (crossing.kind, truth.pose * crossing.ground));
    let found: Vec<(CrossingKind, Pose2)> = found.collect();
    let near = |a: &Pose2, b: &Pose2, quarters: f32| {
        let turn = wrap(quarters * (a.heading - b.heading)).abs();
        a.position.distance(b.position) < CROSSING_NEAR && turn < quarters * CROSSING_TURN
    };
    let quarters = |kind: CrossingKind| if kind == CrossingKind::X { 4.0 } else { 1.0 };
    for (kind, pose) in found.iter().filter(|(_, pose)| truth.distance(pose.position) <= FAR) {
        score.seen(map::crossings(*kind).any(|known| near(&known, pose, quarters(*kind))));
    }
    for kind in [CrossingKind::L, CrossingKind::T, CrossingKind::X] {
        let due = |known: &Pose2| truth.distance(known.position) <= FAR && shows_arms(kind, known, truth);
        for known in map::crossings(kind).filter(due) {
            let same = |(of, pose): &&(CrossingKind, Pose2)| *of == kind && near(&known, pose, quarters(kind));
            let hit = found.iter().find(same);
            score.due(hit.is_some());
            score.error(hit.map(|(_, pose)| 100.0 * pose.position.distance(known.position)));
        }
    }
}

fn shows_arms(kind: CrossingKind, known: &Pose2, truth: &Truth) -> bool {
    let arms: &[Vec2] = match kind {
        CrossingKind::L => &[Vec2::X, Vec2::Y],
        CrossingKind::T => &[Vec2::X, Vec2::Y, Vec2::NEG_Y],
        CrossingKind::X => &[Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y],
    };
    let shown = |arm: &Vec2| [0.0, 0.5 * ARM, ARM].iter().all(|along| is_seen(known.place(*along * *arm), truth));
    arms.iter().all(shown)
}

/// Scores the centre circle: due if a part of its line is visible.
pub(super) fn circle(score: &mut Score, seen: &Detections, truth: &Truth) {
    let off = seen.markings.circle.map(|circle| truth.pose.place(circle.centre).length());
    let hit = off.filter(|off| *off < CIRCLE_NEAR);
    if off.is_some() {
        score.seen(hit.is_some());
    }
    let points = (0..60_u8).map(|i| FIELD.centre_circle_radius() * Vec2::from_angle(TAU / 60.0 * f32::from(i)));
    let shown = points.filter(|at| truth.distance(*at) <= FAR && is_seen(*at, truth)).count();
    if shown as f32 >= CIRCLE_PART * 60.0 {
        score.due(hit.is_some());
        score.error(hit.map(|off| 100.0 * off));
    }
}

/// Scores the boundary row in some columns against the first row with carpet.
pub(super) fn end(score: &mut Score, seen: &Detections, truth: &Truth) {
    for x in (20..SIZE.0 as u16).step_by(40).map(f32::from) {
        let on_carpet = |y: &u16| {
            let ground = truth.camera.ground(Vec2::new(x, f32::from(*y)), 0.0);
            ground.is_some_and(|ground| truth.is_carpet(ground))
        };
        let Some(row) = (0..200).find(on_carpet).map(f32::from) else { continue };
        let off = seen.boundary.row_at(x).map(|found| (found - row).abs());
        let hit = off.filter(|off| *off <= END_NEAR);
        score.due(hit.is_some());
        if let Some(off) = off {
            score.seen(hit.is_some());
            score.error(off);
        }
    }
}
