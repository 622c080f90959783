//! Detection of white field lines as straight segments.
//!
//! Columns and rows of a grid are scanned for bright ridges between green pixels. Ridges that continue straight from
//! scan to scan form a track, which is then extended to both ends of the line. Flat lines come from the columns, steep
//! ones from the rows. A circle yields several short segments.
//!
//! Cost: half of the pixels below the field boundary, once: 40 µs at 320 × 240, 60 µs at 640 × 480.

mod edge_scan;
mod line_track;
mod ridge;
mod stripe;
mod trace;

use bica_core::Params;
use bica_macros::Params;
use glam::Vec2;
use heapless::Vec;

use self::edge_scan::LANES;
use self::line_track::{LineTrack, OPEN};
use self::ridge::Scan;
pub use self::stripe::LINES;
use self::stripe::{Axes, Stripes, join, keep};
use crate::colour::Classify;
use crate::field_boundary::FieldBoundary;
use crate::frame::Frame;
use crate::projection::Camera;

/// Lines of a frame.
pub type Lines = Vec<Line, LINES>;

/// Distance between scans, as a share of the frame height: 4 px at 320 × 240.
const PITCH: f32 = 1.0 / 60.0;
/// Minimum distance between scans, px. At 160 × 120 the pitch of 2 px finds more short segments, a twentieth of the whole length,
/// for 30 % more time; the robot localizes itself as well without them (`--features measure --example localize -- --width 160`).
const MIN_PITCH: u16 = 3;
/// Maximum width of a line, as a share of the frame height.
const WIDEST: f32 = 0.18;
/// Maximum distance of merged segments from the longer segment's line, px at 320 × 240.
const APART: f32 = 1.5;
/// Maximum gap between merged segments, px at 320 × 240.
const BETWEEN: f32 = 40.0;
/// Number of steps in which a line is shortened until its end projects to the ground.
const CUTS: u8 = 16;

/// Detection of lines in an image.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core, check = Self::is_ordered)]
pub struct LineDetection {
    /// Constant part of the minimum luma step from carpet to line; a sixth of the carpet's luma is added.
    #[param(default = 12, range = 1..=100)]
    pub min_rise: u32,
    /// Minimum luma step of a line thinner than a pixel.
    #[param(default = 30, range = 1..=200)]
    pub min_thin_rise: u32,
    /// Minimum width of a line on the ground.
    #[param(default = 0.02, range = 0.0..=0.1, unit = "m", step = 0.005)]
    pub min_line_width: f32,
    /// Maximum width of a line on the ground; anything wider is a robot's limb.
    #[param(default = 0.085, range = 0.02..=0.3, unit = "m", step = 0.005)]
    pub max_line_width: f32,
}

impl LineDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_line_width < self.max_line_width {
            Ok(())
        } else {
            Err("`min_line_width` must be below `max_line_width`")
        }
    }
}

/// Straight segment of a white line: px in the image, m on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end.
    pub from: Vec2,
    /// Other end.
    pub to: Vec2,
}

impl Line {
    /// Length.
    #[must_use]
    pub fn length(&self) -> f32 {
        self.from.distance(self.to)
    }
}

/// Finds the line segments of a frame below the field boundary. With `camera`, segments of a wrong width on the ground
/// are rejected.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
) -> Lines {
    find_tuned(frame, colours, field_boundary, camera, &LineDetection::DEFAULT)
}

/// Finds the line segments as [`find`] does, with thresholds of the caller.
#[must_use]
pub fn find_tuned(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
    tuning: &LineDetection,
) -> Lines {
    let mut stripes = Stripes::new();
    for axes in [Axes::Columns, Axes::Rows] {
        scan(frame, colours, field_boundary, axes, tuning, &mut stripes);
    }
    let scale = f32::from(frame.height()) / 240.0;
    join(&mut stripes, scale * APART, scale * BETWEEN);
    stripes.retain(|stripe| camera.is_none_or(|camera| trace::is_of_width(stripe, camera, tuning)));
    stripes.iter_mut().for_each(|stripe| *stripe = trace::to_the_ends(*stripe, frame));
    join(&mut stripes, scale * APART, scale * BETWEEN);
    stripes.iter().map(|stripe| Line { from: stripe.from, to: stripe.to }).collect()
}

/// Clips lines to the ground within `farthest` m and projects their ends: m, camera's ground frame.
#[must_use]
pub fn on_ground(lines: &[Line], camera: &Camera, farthest: f32) -> Vec<Line, LINES> {
    let ground = |pixel: Vec2| camera.ground(pixel, 0.0).filter(|place| place.length() <= farthest);
    let clipped = lines.iter().filter_map(|line| {
        let near =
            |from: Vec2, to: Vec2| (0..=CUTS).find_map(|cut| ground(from.lerp(to, f32::from(cut) / f32::from(CUTS))));
        Some(Line { from: near(line.from, line.to)?, to: near(line.to, line.from)? })
    });
    clipped.filter(|line| line.from != line.to).collect()
}

fn scan(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    axes: Axes,
    tuning: &LineDetection,
    stripes: &mut Stripes,
) {
    let Some(top) = field_boundary.top() else { return };
    let (side, end) = match axes {
        Axes::Columns => (frame.width(), frame.height()),
        Axes::Rows => (frame.height(), frame.width()),
    };
    let pitch = ((PITCH * f32::from(frame.height())) as u16).max(MIN_PITCH);
    let widest = (WIDEST * f32::from(frame.height())) as u16;
    let first = |across: u16| match axes {
        Axes::Columns => (field_boundary.row_at(across.into()).unwrap_or(top) as u16).min(end),
        Axes::Rows if f32::from(across) >= top => 0,
        Axes::Rows => end,
    };
    let mut open: Vec<LineTrack, OPEN> = Vec::new();
    let mut scans = (pitch / 2..side)
        .step_by(pitch.into())
        .map(|across| (Scan::new(frame, colours, axes, across, widest, tuning), first(across)));
    loop {
        let together: Vec<_, LANES> = scans.by_ref().take(LANES).collect();
        if together.is_empty() {
            break;
        }
        for ((scan, _), ridges) in together.iter().zip(ridge::in_parallel(&together, end)) {
            let place = f32::from(scan.across);
            for ridge in ridges {
                let pixel = axes.pixel(place, ridge.at);
                if field_boundary.is_below(pixel.x, pixel.y, 0.0) {
                    line_track::append(&mut open, place, ridge, pitch.into());
                }
            }
            line_track::close(&mut open, axes, place - 1.5 * f32::from(pitch), |stripe| keep(stripes, stripe));
        }
    }
    line_track::close(&mut open, axes, f32::MAX, |stripe| keep(stripes, stripe));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_a_width() {
        assert!(LineDetection { min_line_width: 0.085, ..LineDetection::DEFAULT }.is_ordered().is_err());
    }
}
