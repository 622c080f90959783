//! Detection of line crossings: corners (L), junctions (T) and crosses (X).
//!
//! Candidates are the intersections of lines that are perpendicular on the ground, and of the centre circle with the halfway line.
//! The image decides which of the four arms of a candidate exist, because detected lines have gaps and a robot or the image edge
//! may hide an arm. A crossing is reported only if the presence or absence of all four arms is known.
//!
//! Cost: each pair of lines once and 16 samples for each candidate, 5 µs.

use core::f32::consts::{FRAC_PI_2, PI};

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use heapless::Vec;
use libm::{atan2f, fabsf};

use crate::centre_circle::CentreCircle;
use crate::colour::Classify;
use crate::frame::Frame;
use crate::line_probe::{Ground, Surface};
use crate::lines::Line;
use crate::projection::Camera;

/// Maximum number of crossings in a frame; more are dropped.
pub const CROSSINGS: usize = 12;

/// Crossings of a frame.
pub type Crossings = Vec<Crossing, CROSSINGS>;

/// Maximum sine of the deviation from a right angle on the ground; short and far lines err most.
const SKEW: f32 = 0.35;
/// Maximum gap between the end of a line and the intersection, m.
const REACH: f32 = 0.3;
/// Distances of the samples on an arm from the crossing, m.
const ALONG: [f32; 4] = [0.09, 0.13, 0.17, 0.21];
/// Minimum number of visible arms of a cross on the circle: its round arms often fail the test.
const CROSS_ARMS: usize = 2;
/// Crossings closer than this are merged, m.
const SAME: f32 = 0.25;

/// Crossing of two lines in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Shape.
    pub kind: CrossingKind,
    /// Position in the image, px.
    pub at: Vec2,
    /// Position, m, and heading, rad, in the camera's ground frame. The heading follows one arm: of an L the arm whose
    /// left neighbour exists, of a T the stem, of an X any arm.
    pub ground: Pose2,
}

/// Finds the crossings among lines on the ground, m, and of the circle with the halfway line, up to `farthest` m away.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    camera: &Camera,
    lines: &[Line],
    circle: Option<&CentreCircle>,
    farthest: f32,
) -> Crossings {
    let search = CrossingSearch { ground: Ground { frame, colours, camera } };
    let pairs = lines.iter().enumerate().flat_map(|(i, a)| lines[i + 1..].iter().map(move |b| (a, b)));
    let is_near = |place: &Pose2| place.position.length() <= farthest;
    let on_circle = circle.into_iter().flat_map(on_circle).filter(is_near);
    let mut found: Crossings = on_circle.filter_map(|place| search.cross(place)).collect();
    for place in pairs.filter_map(|(a, b)| meeting(a, b)).filter(is_near) {
        let is_new = found.iter().all(|other| other.ground.position.distance(place.position) > SAME);
        if is_new && !found.is_full() {
            found.extend(search.crossing(place));
        }
    }
    found
}

/// Intersections of the halfway line with the circle.
fn on_circle(circle: &CentreCircle) -> impl Iterator<Item = Pose2> + use<> {
    let centre = circle.centre;
    let ways = circle.halfway.into_iter().flat_map(|way| [way, -way]);
    ways.map(move |way| Pose2 { position: centre + FIELD.centre_circle_radius() * way, heading: atan2f(way.y, way.x) })
}

/// Intersection of two nearly perpendicular lines on the ground, with the heading of the longer one.
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

struct CrossingSearch<'a, C> {
    ground: Ground<'a, C>,
}

impl<C: Classify> CrossingSearch<'_, C> {
    /// X crossing at a position known from the circle, if it is in view.
    fn cross(&self, ground: Pose2) -> Option<Crossing> {
        let arms = (0..4_u8).filter(|quarters| self.has_arm(ground, f32::from(*quarters) * FRAC_PI_2) == Some(true));
        let at = self.ground.camera.pixel(ground.position.extend(0.0))?;
        (arms.count() >= CROSS_ARMS).then_some(Crossing { kind: CrossingKind::X, at, ground })
    }

    /// Crossing at a position, classified by its arms.
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

    /// Whether a line leaves a position in a direction; `None` if that is hidden or outside the image.
    fn has_arm(&self, place: Pose2, direction: f32) -> Option<bool> {
        let way = Vec2::from_angle(place.heading + direction);
        let (mut lines, mut greens) = (0, 0);
        for along in ALONG {
            match self.ground.surface(place.position + along * way, way.perp()) {
                Some(Surface::Line) => lines += 1,
                Some(Surface::Carpet) => greens += 1,
                Some(Surface::Other) | None => {}
            }
        }
        // At the image edge a few samples of carpet are enough to see that the line ends.
        (lines >= 2 || lines == 0 && greens > 0).then_some(lines > greens)
    }
}
