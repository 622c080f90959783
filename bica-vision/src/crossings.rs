//! Where lines meet: corners (L), junctions (T) and crosses (X).
//!
//! Which of them it is shows in the image, since perspective keeps what ends where; that lines meet at a right angle is
//! checked on the ground. Cost: every pair of lines once, 0.3 µs for ten lines.

use core::f32::consts::FRAC_PI_2;

use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use heapless::Vec;
use libm::{atan2f, fabsf};

use crate::lines::Line;
use crate::projection::Camera;

/// Crossings in a frame; more are dropped.
pub const CROSSINGS: usize = 12;

/// The crossings of a frame.
pub type Crossings = Vec<Crossing, CROSSINGS>;

/// How far from a right angle lines may meet on the ground, rad: the error of far ends.
const SLACK: f32 = 0.4;
/// Lines that meet under a smaller angle in the image are one line.
const LEAST_SINE: f32 = 0.15;
/// Parts of the shorter line that must be to one side of a crossing to be an arm of it.
const ARM: f32 = 0.15;

/// How lines meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingKind {
    /// Both end.
    L,
    /// One ends at the other.
    T,
    /// Both go on.
    X,
}

/// A crossing of two lines in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// How the lines meet.
    pub kind: CrossingKind,
    /// Where, px.
    pub at: Vec2,
    /// The end of one arm, px: of the stem if it is a T.
    pub first: Vec2,
    /// The end of an arm across the first one, px.
    pub second: Vec2,
}

impl Crossing {
    /// Place and heading on the ground, m and rad in the camera's ground frame. The heading goes along an arm: that of
    /// an L which has the other one at its left, the stem of a T, any arm of an X. None if the crossing is not seen on
    /// the ground or is not near a right angle there.
    #[must_use]
    pub fn ground(&self, camera: &Camera) -> Option<Pose2> {
        let at = camera.ground(self.at, 0.0)?;
        let way = |end: Vec2| Some(camera.ground(at_most(self.at, end), 0.0)? - at);
        let (first, second) = (way(self.first)?, way(self.second)?);
        let angle = |way: Vec2| atan2f(way.y, way.x);
        let turn = wrap(angle(second) - angle(first));
        let is_right = fabsf(fabsf(turn) - FRAC_PI_2) < SLACK;
        // Half of the error of each arm is in the heading.
        let first_turns_left = self.kind != CrossingKind::L || turn > 0.0;
        let heading = if first_turns_left { angle(first) } else { angle(second) };
        let correction = 0.5 * (fabsf(turn) - FRAC_PI_2);
        let side = if turn > 0.0 || self.kind == CrossingKind::L { 1.0 } else { -1.0 };
        is_right.then(|| Pose2 { position: at, heading: wrap(heading + side * correction) })
    }
}

/// The part of an arm that its direction is taken from: far along it the ground is uncertain.
fn at_most(at: Vec2, end: Vec2) -> Vec2 {
    at + (end - at).clamp_length_max(60.0)
}

/// The crossings among the lines of an image. Lines meet if they come within `reach` px of each other.
#[must_use]
pub fn among(lines: &[Line], reach: f32) -> Vec<Crossing, CROSSINGS> {
    let pairs = lines.iter().enumerate().flat_map(|(i, a)| lines[i + 1..].iter().map(move |b| (a, b)));
    let mut found: Vec<Crossing, CROSSINGS> = Vec::new();
    for crossing in pairs.filter_map(|(a, b)| cross(a, b, reach)) {
        let is_new = found.iter().all(|other| other.at.distance(crossing.at) > reach);
        if is_new && !found.is_full() {
            found.extend([crossing]);
        }
    }
    found
}

fn cross(a: &Line, b: &Line, reach: f32) -> Option<Crossing> {
    let (along, across, between) = (a.to - a.from, b.to - b.from, b.from - a.from);
    let area = along.perp_dot(across);
    if fabsf(area) < LEAST_SINE * along.length() * across.length() {
        return None;
    }
    let (t, u) = (between.perp_dot(across) / area, between.perp_dot(along) / area);
    let (first, second) = (Meeting::of(a, t, reach)?, Meeting::of(b, u, reach)?);
    let (kind, first, second) = match (first.goes_on, second.goes_on) {
        (true, true) => (CrossingKind::X, first, second),
        (true, false) => (CrossingKind::T, second, first),
        (false, true) => (CrossingKind::T, first, second),
        (false, false) => (CrossingKind::L, first, second),
    };
    let at = a.from + t * along;
    at.is_finite().then_some(Crossing { kind, at, first: first.end, second: second.end })
}

/// How one line comes to a crossing.
struct Meeting {
    /// The end farther from the crossing.
    end: Vec2,
    goes_on: bool,
}

impl Meeting {
    /// `share`: where the crossing is on the line, 0 at its start, 1 at its end. None if that is out of reach.
    fn of(line: &Line, share: f32, reach: f32) -> Option<Self> {
        let length = line.length();
        let (before, after) = (share * length, (1.0 - share) * length);
        let arm = reach.max(ARM * length.min(4.0 * reach));
        let end = if before > after { line.from } else { line.to };
        (before.min(after) >= -reach).then_some(Self { end, goes_on: before > arm && after > arm })
    }
}

#[cfg(test)]
mod tests {
    use glam::{Affine3A, Quat, Vec3};

    use super::*;
    use crate::projection::Intrinsics;

    fn line(from: (f32, f32), to: (f32, f32)) -> Line {
        Line { from: from.into(), to: to.into() }
    }

    #[test]
    fn what_ends_where_tells_the_kind() {
        let bar = line((10.0, 50.0), (110.0, 50.0));
        for (other, kind, at) in [
            (line((60.0, 10.0), (60.0, 90.0)), Some(CrossingKind::X), (60.0, 50.0)),
            (line((60.0, 54.0), (70.0, 120.0)), Some(CrossingKind::T), (59.4, 50.0)),
            (line((13.0, 44.0), (10.0, 0.0)), Some(CrossingKind::L), (13.4, 50.0)),
            (line((60.0, 70.0), (60.0, 120.0)), None, (0.0, 0.0)),
            (line((20.0, 52.0), (100.0, 55.0)), None, (0.0, 0.0)),
        ] {
            let found = among(&[bar, other], 8.0);
            assert_eq!(found.first().map(|crossing| crossing.kind), kind);
            assert!(found.iter().all(|crossing| crossing.at.distance(at.into()) < 0.1), "{found:?}");
        }
    }

    #[test]
    fn a_heading_on_the_ground_is_found_again() {
        let pose = Affine3A::from_rotation_translation(Quat::from_rotation_y(0.5), Vec3::new(0.0, 0.0, 0.5));
        let camera = Camera::new(pose, Intrinsics::nao_v6(320, 240));
        for step in 0..12_u8 {
            let heading = 0.5 * f32::from(step) + 0.1;
            let place = Pose2::new(1.1, 0.1, wrap(heading));
            let pixel = |ahead: f32, left: f32| camera.pixel(place.place(Vec2::new(ahead, left)).extend(0.0)).unwrap();
            let (middle, arms) = (pixel(0.0, 0.0), [pixel(0.3, 0.0), pixel(0.0, 0.3), pixel(0.0, -0.3)]);
            let corner = [Line { from: middle, to: arms[1] }, Line { from: arms[0], to: middle }];
            let junction = [Line { from: arms[2], to: arms[1] }, Line { from: arms[0], to: middle }];
            for (kind, lines) in [(CrossingKind::L, corner), (CrossingKind::T, junction)] {
                let found = among(&lines, 6.0);
                assert_eq!(found.len(), 1);
                let ground = found[0].ground(&camera).expect("a right angle");
                assert_eq!(found[0].kind, kind);
                assert!(ground.position.distance(place.position) < 1e-3, "{ground:?}");
                assert!(wrap(ground.heading - heading).abs() < 1e-2, "{kind:?} {ground:?} {heading}");
            }
        }
    }
}
