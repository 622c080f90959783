//! Detection of the orange ball.
//!
//! Candidates are connected regions of orange pixels on the field or at its boundary. A circle is fitted to the edge
//! points of each candidate, so the image edge, the robot's own feet or another robot may occlude a part of the ball. A
//! candidate is accepted if it is round (edge points agree with the circle), filled (orange inside) and, with a known
//! camera pose, of the size of a ball at that position.
//!
//! Cost at 320 × 240: 30 µs for the segmentation of the whole frame, less with a visible field boundary; then 2 to 15
//! µs for each candidate, depending on its size. There are at most [`CANDIDATES`] candidates.

use core::cell::Cell;

use bica_core::Params;
use bica_macros::Params;
use glam::Vec2;

use crate::circle::Circle;
use crate::colour::{Classify, Colour, ColourSet};
use crate::edges::{self, RAYS};
use crate::field_boundary::FieldBoundary;
use crate::frame::{Frame, Pixel};
use crate::hypothesis::ImageCircle;
use crate::memory::PositionEstimate;
use crate::own_body::OwnBody;
use crate::projection::Camera;
use crate::regions::{Region, Regions};
use crate::segment::{Area, Runs};
use crate::uncertainty::Errors;

/// Maximum number of orange regions examined, the largest first.
pub const CANDIDATES: usize = 8;
/// Ball radius in the recorded frames `nao2009`, m.
pub const RADIUS_2009: f32 = 0.043;

/// Pixel budget of the edge search over all candidates. Recorded images need 10 548 pixels at most.
const PIXEL_BUDGET: u32 = 12_000;
/// Maximum mean number of runs per row in a region of a ball.
const PIECES: u16 = 3;

/// Detection of the ball in an image.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core)]
pub struct BallDetection {
    /// Minimum confidence of a ball with a radius of at least 12 px.
    #[param(default = 0.4, range = 0.0..=1.0, step = 0.01)]
    pub min_confidence: f32,
    /// Minimum confidence of a ball with a radius up to 6 px; interpolated up to 12 px.
    #[param(default = 0.6, range = 0.0..=1.0, step = 0.01)]
    pub min_confidence_if_small: f32,
    /// Maximum share of an orange region that the robot's own body may cover.
    #[param(default = 0.6, range = 0.0..=1.0, step = 0.05)]
    pub max_own_share: f32,
    /// Consecutive sightings that confirm the ball.
    #[param(default = 2, range = 1..=30)]
    pub confirmations: u32,
    /// Time without a confirmed sighting after which the ball is lost.
    #[param(default = 2000, range = 0..=60_000, unit = "ms", step = 100)]
    pub lost_after: u32,
}

impl BallDetection {
    fn needed_confidence(&self, radius: f32) -> f32 {
        let small = ((12.0 - radius) / 6.0).clamp(0.0, 1.0);
        self.min_confidence + small * (self.min_confidence_if_small - self.min_confidence)
    }
}

/// Ball in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Centre, px; may lie outside the image.
    pub centre: Vec2,
    /// Radius, px.
    pub radius: f32,
    /// Confidence, 0 to 1: product of roundness and fill.
    pub confidence: f32,
}

impl Ball {
    /// Position on the ground from the camera pose, ground frame, m. `radius` is the ball's radius, m. `None` if the
    /// centre is not below the horizon.
    #[must_use]
    pub fn ground(&self, camera: &Camera, radius: f32) -> Option<Vec2> {
        camera.ground(self.centre, radius)
    }

    /// Position on the ground with its covariance. The apparent size corrects the position where it is more certain
    /// than the camera pose, whose errors are `errors`. `None` if the circle fits no ball on the ground.
    #[must_use]
    pub fn estimate(&self, camera: &Camera, radius: f32, errors: &Errors) -> Option<PositionEstimate> {
        ImageCircle { centre: self.centre, radius: self.radius }.ball(camera, radius, errors)
    }
}

/// Ball detector with memory for `N` runs, 12 bytes each.
///
/// `N` = 512 is enough in a hall: only orange pixels below the field boundary make runs.
#[derive(Clone, Debug)]
pub struct BallFinder<const N: usize> {
    runs: Runs<N>,
    regions: Regions<N, CANDIDATES>,
    radius: f32,
}

impl<const N: usize> BallFinder<N> {
    /// Creates a detector for balls of a radius in metres.
    #[must_use]
    pub const fn new(radius: f32) -> Self {
        Self { runs: Runs::new(), regions: Regions::new(), radius }
    }

    /// Finds the ball in a frame. Segments orange only. With `camera`, balls of a wrong size are rejected.
    pub fn find(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        field_boundary: &FieldBoundary,
        camera: Option<&Camera>,
    ) -> Option<Ball> {
        let camera = camera.map(|camera| (camera, &Errors::NAO));
        self.find_tuned(frame, colours, field_boundary, camera, &OwnBody::NONE, &BallDetection::DEFAULT)
    }

    /// Finds the ball as [`find`](Self::find) does, with thresholds of the caller and the errors of the camera's pose, and ignores
    /// orange pixels on the robot's own body.
    pub fn find_tuned(
        &mut self,
        frame: &Frame<'_>,
        colours: &impl Classify,
        field_boundary: &FieldBoundary,
        camera: Option<(&Camera, &Errors)>,
        own: &OwnBody,
        detection: &BallDetection,
    ) -> Option<Ball> {
        let area = Area::below((field_boundary.top().unwrap_or(0.0) - 8.0).max(0.0) as u16);
        // A ball of 3 px radius spans enough of every second row. The edge search reads all rows.
        self.runs.segment(frame, colours, ColourSet::of(Colour::Orange), area.every(2));
        self.regions.connect(&self.runs, 6);
        let radius = self.radius;
        let left = Cell::new(PIXEL_BUDGET);
        CandidateSearch { frame, colours, field_boundary, camera, radius, own, detection, left }
            .best(self.regions.as_slice())
    }
}

/// Whether a region has more runs per row than a ball with a highlight and an occlusion.
fn is_frayed(region: &Region) -> bool {
    region.runs > PIECES * region.height()
}

/// Mean chroma of one ball. Shaded and bright parts, which the colour class may miss, have the same hue.
#[derive(Clone, Copy)]
struct Shade {
    b: i32,
    r: i32,
}

impl Shade {
    fn of(pixel: Pixel) -> Self {
        Self { b: i32::from(pixel.cb) - 128, r: i32::from(pixel.cr) - 128 }
    }

    /// Whether the hue is within 6° and the chroma at least 0.6 times as strong.
    fn is_like(self, pixel: Pixel) -> bool {
        let other = Self::of(pixel);
        let (along, across) = (self.b * other.b + self.r * other.r, self.b * other.r - self.r * other.b);
        let strength = self.b * self.b + self.r * self.r;
        5 * along >= 3 * strength && 19 * across.abs() <= 2 * along
    }
}

struct CandidateSearch<'a, C> {
    frame: &'a Frame<'a>,
    colours: &'a C,
    field_boundary: &'a FieldBoundary,
    /// Camera, and the errors of its pose.
    camera: Option<(&'a Camera, &'a Errors)>,
    /// Radius of the ball, m.
    radius: f32,
    own: &'a OwnBody,
    detection: &'a BallDetection,
    /// Rest of the pixel budget [`PIXEL_BUDGET`].
    left: Cell<u32>,
}

impl<C: Classify> CandidateSearch<'_, C> {
    /// Returns the best ball among regions. Examines them in their order.
    fn best(&self, regions: &[Region]) -> Option<Ball> {
        let balls = regions.iter().filter(|r| r.colour == Colour::Orange).filter_map(|region| self.examine(region));
        // A far ball is as good as a near one, but a small region is more often a false positive.
        let worth = |ball: &Ball| ball.confidence * (ball.radius / (ball.radius + 2.0));
        balls.max_by(|a, b| worth(a).total_cmp(&worth(b)))
    }

    fn examine(&self, region: &Region) -> Option<Ball> {
        if self.left.get() == 0 {
            return None;
        }
        let shade = if is_frayed(region) { None } else { self.shade(region) }?;
        let (Circle { centre, radius }, roundness) = self.circle(region, shade)?;
        let confidence = roundness * self.fullness(centre, radius, shade);
        let fits = self.is_sufficiently_visible(centre, radius) && self.is_on_field(centre, radius);
        let fits = fits && self.is_of_size(centre, radius) && !self.is_own(region);
        (confidence >= self.detection.needed_confidence(radius) && fits).then_some(Ball { centre, radius, confidence })
    }

    fn is_orange(&self, pixel: Pixel, shade: Shade) -> bool {
        shade.is_like(pixel) || self.colours.classify(pixel) == Colour::Orange
    }

    /// Mean chroma of the orange pixels on a grid over the region's bounding box.
    fn shade(&self, region: &Region) -> Option<Shade> {
        let (mut sum, mut count) = (Shade { b: 0, r: 0 }, 0);
        for v in 0..9 {
            for u in 0..9 {
                let x = i32::from(region.x0) + i32::from(region.width()) * (2 * u + 1) / 18;
                let y = i32::from(region.y0) + i32::from(region.height()) * (2 * v + 1) / 18;
                let pixel = self.frame.pixel(x, y).filter(|pixel| self.colours.classify(*pixel) == Colour::Orange);
                if let Some(pixel) = pixel {
                    let shade = Shade::of(pixel);
                    (sum, count) = (Shade { b: sum.b + shade.b, r: sum.r + shade.r }, count + 1);
                }
            }
        }
        (count > 0).then(|| Shade { b: sum.b / count, r: sum.r / count })
    }

    /// Circle through the region's edge, and the share of edge points that agree with it.
    fn circle(&self, region: &Region, shade: Shade) -> Option<(Circle, f32)> {
        let size = f32::from(region.width().max(region.height()));
        let middle = Vec2::from(region.centroid);
        let edges = edges::around(self.frame, |pixel| self.is_orange(pixel, shade), middle, size);
        self.left.set(self.left.get().saturating_sub(edges.reads));
        let tolerance = |radius: f32| (0.06 * radius).max(1.0);
        let circle = Circle::fit(&edges.points, tolerance)?;
        let near = tolerance(circle.radius);
        let agree = circle.support(&edges.points, near);
        // An edge point inside the circle may belong to an occluding object.
        let hidden = edges.points.iter().filter(|point| circle.distance(**point) < -near).count();
        let ended = (RAYS - edges.clipped) as f32;
        let compact = size <= 2.6 * circle.radius + 3.0;
        let plausible = circle.radius >= 2.0 && circle.radius <= 2.0 * size && compact && agree >= RAYS / 5;
        plausible.then_some((circle, (agree as f32 + 0.5 * hidden as f32) / ended))
    }

    /// Share of orange pixels in the circle, of those within the image.
    fn fullness(&self, centre: Vec2, radius: f32, shade: Shade) -> f32 {
        let (mut orange, mut seen) = (0, 0);
        for v in -4..=4_i8 {
            for u in -4..=4_i8 {
                let offset = Vec2::new(f32::from(u), f32::from(v)) * 0.2;
                let at = centre + radius * offset;
                let pixel = self.frame.pixel(at.x as i32, at.y as i32).filter(|_| offset.length_squared() <= 0.7);
                if let Some(pixel) = pixel {
                    seen += 1;
                    orange += i32::from(self.is_orange(pixel, shade));
                }
            }
        }
        orange as f32 / seen.max(1) as f32
    }

    /// Whether the centre is in the image or the ball is large: a circle through a sliver of a small ball is unreliable.
    fn is_sufficiently_visible(&self, centre: Vec2, radius: f32) -> bool {
        let size = Vec2::new(f32::from(self.frame.width()), f32::from(self.frame.height()));
        let outside = (-centre).max(centre - size + Vec2::ONE).max_element();
        outside <= 0.2 * radius || radius > size.x / 20.0
    }

    /// Whether most of the ball is below the field boundary. For a large ball, which may cover the field, the lowest
    /// point is enough. Without a boundary only a large ball is accepted.
    fn is_on_field(&self, centre: Vec2, radius: f32) -> bool {
        let width = f32::from(self.frame.width());
        // At the image edge the ball itself covers the field boundary: use the rows beside it.
        let ends = [-1.4, 0.0, 1.4].map(|side| self.field_boundary.row_at(centre.x + side * radius));
        match ends.into_iter().flatten().reduce(f32::min) {
            Some(end) if radius > width / 16.0 => centre.y + 1.05 * radius >= end,
            Some(end) => centre.y + 0.5 * radius >= end,
            None => radius > width / 8.0,
        }
    }

    /// Whether the robot's own body covers most of the region.
    fn is_own(&self, region: &Region) -> bool {
        let radius = 0.4 * f32::from(region.width().min(region.height()));
        self.own.share(Vec2::from(region.centroid), radius) > self.detection.max_own_share
    }

    /// Whether the circle has the size of a ball on the ground at that position.
    fn is_of_size(&self, centre: Vec2, radius: f32) -> bool {
        let Some((camera, errors)) = self.camera else { return true };
        ImageCircle { centre, radius }.ball(camera, self.radius, errors).is_some()
    }
}
