//! Whether a place of the ground is painted: a look-up in the image for those who know where a line should be.
//!
//! Cost: six pixels and three projections for each place, 60 ns.

use glam::Vec2;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;
use crate::projection::Camera;

/// How far beside a line there must be carpet: m, and px at 320 × 240 at least.
const ASIDE: (f32, f32) = (0.06, 2.0);
/// How much brighter than that a line is, of 255, and as a part of the carpet's luma.
const RISE: (f32, f32) = (10.0, 0.1);

/// The ground as a camera sees it.
#[derive(Clone, Copy)]
pub(crate) struct Ground<'a, C> {
    pub(crate) frame: &'a Frame<'a>,
    pub(crate) colours: &'a C,
    pub(crate) camera: &'a Camera,
}

/// What there is on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    /// A line.
    Line,
    /// Carpet.
    Carpet,
    /// Something else, or something that stands before it.
    Other,
}

impl<C: Classify> Ground<'_, C> {
    /// What is at a place, m in the camera's ground frame, where a line would have `across` (length 1) at a right angle.
    /// None if that is beside the image.
    pub(crate) fn shows(&self, place: Vec2, across: Vec2) -> Option<Shown> {
        let middle = self.camera.pixel(place.extend(0.0))?;
        let offset = self.camera.pixel((place + ASIDE.0 * across).extend(0.0))? - middle;
        let step = offset.try_normalize()?;
        let offset = step * offset.length().max(ASIDE.1 * f32::from(self.frame.height()) / 240.0);
        let luma = |at: Vec2| self.frame.nearest(at).map(|pixel| f32::from(pixel.y));
        let sides = luma(middle - offset)?.max(luma(middle + offset)?);
        let brightest = luma(middle)?.max(luma(middle - 0.7 * step)?).max(luma(middle + 0.7 * step)?);
        let rises = brightest > sides + RISE.0 + RISE.1 * sides;
        Some(match self.colours.classify(self.frame.nearest(middle)?) {
            Colour::White | Colour::None | Colour::Green if rises => Shown::Line,
            Colour::Green => Shown::Carpet,
            _ => Shown::Other,
        })
    }
}
