//! Edge points of a blob on rays from its middle.
//!
//! A ray continues while pixels belong to the blob, across small gaps such as a highlight. The edge is where the
//! redness Cr − Cb crosses the mean of its values inside and outside, with subpixel accuracy. Rays of large blobs are
//! sampled with a stride, so no blob costs more than one of `FINE` pixels. Cost: 4 ns for each pixel read on [`RAYS`]
//! rays, 2 µs for a blob of 20 px, 8 µs for one that fills the image.

use glam::Vec2;
use heapless::Vec;

use crate::frame::{Frame, Pixel};

/// Number of rays.
pub const RAYS: usize = 32;

/// Width of the largest blob sampled at every pixel, px.
const FINE: f32 = 64.0;
/// Maximum share of a ray in holes, apart from one large gap; noise has more.
const HOLES: f32 = 0.25;

/// Result of the edge search.
#[derive(Clone, Debug, Default)]
pub struct Edges {
    /// Edge points, counter-clockwise in the image, px.
    pub points: Vec<Vec2, RAYS>,
    /// Number of rays that left the image inside the blob.
    pub clipped: usize,
    /// Number of rays that ended at a change of class with nearly no change of colour.
    pub faint: usize,
    /// Number of pixels read on all rays.
    pub reads: u32,
}

enum End {
    At(Vec2),
    Image,
    Faint,
}

/// Follows rays from `centre` through pixels that `belong` to the blob, up to twice the blob's `size`, its approximate width in px.
#[must_use]
pub fn around(frame: &Frame<'_>, belongs: impl Fn(Pixel) -> bool, centre: Vec2, size: f32) -> Edges {
    let mut edges = Edges::default();
    // Rotation by a constant angle avoids a sine in the loop.
    let turn = Vec2::new(0.980_785_25, 0.195_090_32);
    let mut along = Vec2::X;
    for _ in 0..RAYS {
        let ray = Ray { frame, centre, along, reach: 2.0 + size / 16.0, stride: 1.0 + (size / FINE) as u8 as f32 };
        let (end, reads) = ray.end(&belongs, 2.0 + size / 8.0, 2.0 * size);
        edges.reads += reads;
        match end {
            End::At(point) => edges.points.extend([point]),
            End::Image => edges.clipped += 1,
            End::Faint => edges.faint += 1,
        }
        along = along.rotate(turn);
    }
    edges
}

struct Ray<'a> {
    frame: &'a Frame<'a>,
    centre: Vec2,
    along: Vec2,
    /// Distance from the edge to the two compared samples, px.
    reach: f32,
    /// Distance between samples, px.
    stride: f32,
}

impl Ray<'_> {
    #[cfg_attr(any(target_arch = "x86_64", target_arch = "aarch64"), inline(always))]
    fn pixel(&self, distance: f32) -> Option<Pixel> {
        self.frame.nearest(self.centre + self.along * distance)
    }

    fn redness(&self, distance: f32) -> Option<f32> {
        self.pixel(distance).map(|p| f32::from(p.cr) - f32::from(p.cb))
    }

    /// End of the blob on the ray, and the number of pixels read.
    fn end(&self, belongs: &impl Fn(Pixel) -> bool, gap: f32, farthest: f32) -> (End, u32) {
        let (mut last, mut at, mut beside, mut reads) = (0.0, 0.0, 0.0, 0);
        while at <= farthest.min(last) + gap && beside <= gap + HOLES * at {
            (at, reads) = (at + self.stride, reads + 1);
            let Some(pixel) = self.pixel(at) else { break };
            if belongs(pixel) {
                last = at;
            } else {
                beside += self.stride;
            }
        }
        if self.pixel(last + self.stride + 1.0).is_none() {
            return (End::Image, reads);
        }
        (self.crossing(last).map_or(End::Faint, |distance| End::At(self.centre + self.along * distance)), reads)
    }

    /// Position where the redness crosses the mean of its values on both sides of the coarse edge.
    fn crossing(&self, coarse: f32) -> Option<f32> {
        let mut distance = (coarse - self.reach).max(0.0);
        let inside = self.redness(distance)?;
        let outside = self.redness(coarse + self.reach + 1.0).or_else(|| self.redness(coarse + 2.0))?;
        if inside - outside < (0.3 * inside).max(12.0) {
            return None;
        }
        let (middle, mut before) = (0.5 * (inside + outside), inside);
        for step in [self.stride, 1.0] {
            while distance <= coarse + self.reach {
                let here = self.redness(distance + step)?;
                if here < middle {
                    break;
                }
                (distance, before) = (distance + step, here);
            }
        }
        let here = self.redness(distance + 1.0)?;
        (here < middle).then(|| distance + 1.0 - (middle - here) / (before - here).max(1.0))
    }
}
