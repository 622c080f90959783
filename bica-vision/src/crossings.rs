//! Where lines meet: corners (L), junctions (T) and crosses (X).
//!
//! Lines that would meet at a right angle on the ground, and the centre circle with the halfway line, say where one may be.
//! Which of its four arms are there is then looked up in the image, since lines are seen with gaps and a robot or the
//! image's edge may hide an arm: unless all four are known to be there or not, there is no telling what it is.
//! Cost: every pair of lines once and 16 places for each candidate, 5 µs.

use core::f32::consts::{FRAC_PI_2, PI};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use heapless::Vec;
use libm::{atan2f, fabsf};

use crate::centre_circle::CentreCircle;
use crate::colour::Classify;
use crate::frame::Frame;
use crate::lines::Line;
use crate::paint::{Ground, Shown};
use crate::projection::Camera;

/// Crossings in a frame; more are dropped.
pub const CROSSINGS: usize = 12;

/// The crossings of a frame.
pub type Crossings = Vec<Crossing, CROSSINGS>;

/// Crossings farther away than this are not looked for, m.
const FARTHEST: f32 = 3.5;
/// The sine of how far from a right angle lines may meet on the ground: the error of short and far ones.
const SKEW: f32 = 0.35;
/// How far beyond its end a line may meet another, m.
const REACH: f32 = 0.3;
/// Where on an arm it is looked for, m from the crossing.
const ALONG: [f32; 4] = [0.09, 0.13, 0.17, 0.21];
/// Arms of a cross on the circle that are seen at least: the round ones often are not.
const CROSS_ARMS: usize = 2;
/// Crossings that are nearer to each other are one, m.
const SAME: f32 = 0.25;

/// A crossing of two lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// How the lines meet.
    pub kind: CrossingKind,
    /// Where, px.
    pub at: Vec2,
    /// PositionEstimate and heading on the ground, m and rad in the camera's ground frame. The heading goes along an arm: that of an
    /// L which has the other one at its left, the stem of a T, any arm of an X.
    pub ground: Pose2,
}

/// The crossings among lines on the ground, m, and of the circle with the halfway line if it was found.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    camera: &Camera,
    lines: &[Line],
    circle: Option<&CentreCircle>,
) -> Crossings {
    let look = Look { ground: Ground { frame, colours, camera } };
    let pairs = lines.iter().enumerate().flat_map(|(i, a)| lines[i + 1..].iter().map(move |b| (a, b)));
    let is_near = |place: &Pose2| place.position.length() <= FARTHEST;
    let on_circle = circle.into_iter().flat_map(on_circle).filter(is_near);
    let mut found: Crossings = on_circle.filter_map(|place| look.cross(place)).collect();
    for place in pairs.filter_map(|(a, b)| meeting(a, b)).filter(is_near) {
        let is_new = found.iter().all(|other| other.ground.position.distance(place.position) > SAME);
        if is_new && !found.is_full() {
            found.extend(look.crossing(place));
        }
    }
    found
}

/// Where the halfway line crosses the circle.
fn on_circle(circle: &CentreCircle) -> impl Iterator<Item = Pose2> + use<> {
    let centre = circle.centre;
    let ways = circle.halfway.into_iter().flat_map(|way| [way, -way]);
    ways.map(move |way| Pose2 { position: centre + FIELD.centre_circle_radius() * way, heading: atan2f(way.y, way.x) })
}

/// Where two lines on the ground would meet at about a right angle, heading along the longer one.
fn meeting(a: &Line, b: &Line) -> Option<Pose2> {
    let (long, short) = if a.length() >= b.length() { (a, b) } else { (b, a) };
    let along = (long.to - long.from).try_normalize()?;
    let across = (short.to - short.from).try_normalize()?;
    if fabsf(along.dot(across)) > SKEW {
        return None;
    }
    let (between, area) = (short.from - long.from, along.perp_dot(across));
    let (on_long, on_short) = (between.perp_dot(across) / area, between.perp_dot(along) / area);
    let reaches = |place: f32, line: &Line| place >= -REACH && place <= line.length() + REACH;
    let position = long.from + on_long * along;
    let meets = reaches(on_long, long) && reaches(on_short, short) && position.is_finite();
    meets.then(|| Pose2 { position, heading: atan2f(along.y, along.x) })
}

struct Look<'a, C> {
    ground: Ground<'a, C>,
}

impl<C: Classify> Look<'_, C> {
    /// A cross, where one is known to be if its place is in sight.
    fn cross(&self, ground: Pose2) -> Option<Crossing> {
        let arms = (0..4_u8).filter(|quarters| self.has_arm(ground, f32::from(*quarters) * FRAC_PI_2) == Some(true));
        let at = self.ground.camera.pixel(ground.position.extend(0.0))?;
        (arms.count() >= CROSS_ARMS).then_some(Crossing { kind: CrossingKind::X, at, ground })
    }

    /// The crossing at a place, by which of its arms are there.
    fn crossing(&self, place: Pose2) -> Option<Crossing> {
        let mut arms = [false; 4];
        for (arm, quarters) in arms.iter_mut().zip(0_u8..) {
            *arm = self.has_arm(place, f32::from(quarters) * FRAC_PI_2)?;
        }
        let (kind, turn) = match arms {
            [true, true, true, true] => (CrossingKind::X, 0.0),
            [true, true, false, true] => (CrossingKind::T, 0.0),
            [true, true, true, false] => (CrossingKind::T, FRAC_PI_2),
            [false, true, true, true] => (CrossingKind::T, PI),
            [true, false, true, true] => (CrossingKind::T, -FRAC_PI_2),
            [true, true, false, false] => (CrossingKind::L, 0.0),
            [false, true, true, false] => (CrossingKind::L, FRAC_PI_2),
            [false, false, true, true] => (CrossingKind::L, PI),
            [true, false, false, true] => (CrossingKind::L, -FRAC_PI_2),
            _ => return None,
        };
        let at = self.ground.camera.pixel(place.position.extend(0.0))?;
        Some(Crossing { kind, at, ground: Pose2 { heading: wrap(place.heading + turn), ..place } })
    }

    /// Whether a line goes from a place into a direction; none if that is hidden or beside the image.
    fn has_arm(&self, place: Pose2, direction: f32) -> Option<bool> {
        let way = Vec2::from_angle(place.heading + direction);
        let (mut lines, mut greens) = (0, 0);
        for along in ALONG {
            match self.ground.shows(place.position + along * way, way.perp()) {
                Some(Shown::Line) => lines += 1,
                Some(Shown::Carpet) => greens += 1,
                Some(Shown::Other) | None => {}
            }
        }
        // At the image's edge little carpet is enough to know that the line does not go on.
        (lines >= 2 || lines == 0 && greens > 0).then_some(lines > greens)
    }
}
