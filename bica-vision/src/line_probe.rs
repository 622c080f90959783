//! Classification of single ground points, to verify a predicted line in the image.
//!
//! Cost: six pixels and three projections for each point, 60 ns.

use glam::Vec2;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;
use crate::projection::Camera;

/// Distance of the samples on the carpet beside a line, m.
const ASIDE: f32 = 0.06;
/// Minimum distance of these samples, px at 320 × 240.
const ASIDE_PIXELS: f32 = 2.0;
/// Constant part of a line's minimum contrast, 0 to 255.
const RISE: f32 = 10.0;
/// Part of a line's minimum contrast that is proportional to the carpet's luma.
const RISE_SHARE: f32 = 0.1;

/// Ground as a camera sees it.
#[derive(Clone, Copy)]
pub(crate) struct Ground<'a, C> {
    pub(crate) frame: &'a Frame<'a>,
    pub(crate) colours: &'a C,
    pub(crate) camera: &'a Camera,
}

/// Surface at a ground point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Surface {
    /// Line.
    Line,
    /// Carpet.
    Carpet,
    /// Other surface, or an occluding object.
    Other,
}

impl<C: Classify> Ground<'_, C> {
    /// Classifies a point, m in the camera's ground frame, on an expected line with the normal `across` (unit vector).
    /// `None` outside the image.
    pub(crate) fn surface(&self, place: Vec2, across: Vec2) -> Option<Surface> {
        let middle = self.camera.pixel(place.extend(0.0))?;
        let offset = self.camera.pixel((place + ASIDE * across).extend(0.0))? - middle;
        let step = offset.try_normalize()?;
        let offset = step * offset.length().max(ASIDE_PIXELS * f32::from(self.frame.height()) / 240.0);
        let luma = |at: Vec2| self.frame.nearest_luma(at);
        let pixel = self.frame.nearest(middle)?;
        let sides = f32::from(luma(middle - offset)?.max(luma(middle + offset)?));
        let brightest = f32::from(pixel.y.max(luma(middle - 0.7 * step)?).max(luma(middle + 0.7 * step)?));
        let rises = brightest > sides + RISE + RISE_SHARE * sides;
        Some(match self.colours.classify(pixel) {
            Colour::White | Colour::None | Colour::Green if rises => Surface::Line,
            Colour::Green => Surface::Carpet,
            _ => Surface::Other,
        })
    }
}
