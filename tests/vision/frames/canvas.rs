//! Synthetic frames.

use bica_vision::frame::{Frame, Pixel};
use glam::{Vec2, Vec3};

pub(crate) const CARPET: Pixel = Pixel::new(85, 115, 114);
pub(crate) const WALL: Pixel = Pixel::new(170, 125, 131);
pub(crate) const LINE: Pixel = Pixel::new(190, 126, 129);
pub(crate) const ORANGE: Pixel = Pixel::new(130, 88, 177);
pub(crate) const RED: Pixel = Pixel::new(90, 108, 182);
pub(crate) const YELLOW: Pixel = Pixel::new(140, 52, 142);
pub(crate) const BLUE: Pixel = Pixel::new(95, 150, 106);

/// Image of antialiased shapes with a little position-dependent noise.
#[derive(Clone)]
pub(crate) struct Canvas {
    width: u16,
    height: u16,
    /// Luma, Cb and Cr.
    pixels: Vec<Vec3>,
}

impl Canvas {
    /// Image with a wall above the row `end` and carpet below it.
    pub(crate) fn field(width: u16, height: u16, end: f32) -> Self {
        let pixels = vec![parts(CARPET); usize::from(width) * usize::from(height)];
        let mut canvas = Self { width, height, pixels };
        canvas.paint(WALL, |at| end - at.y);
        canvas
    }

    /// Paints the points at which `inside`, the signed distance to the edge, px, is positive.
    pub(crate) fn paint(&mut self, colour: Pixel, inside: impl Fn(Vec2) -> f32) {
        self.paint_between(colour, Vec2::ZERO, Vec2::new(self.width.into(), self.height.into()), inside);
    }

    pub(crate) fn disc(&mut self, colour: Pixel, centre: Vec2, radius: f32) {
        self.paint_between(colour, centre - radius, centre + radius, |at| radius - at.distance(centre));
    }

    /// Paints a straight bar between two points.
    pub(crate) fn bar(&mut self, colour: Pixel, from: Vec2, to: Vec2, width: f32) {
        let along = to - from;
        let (first, last) = (from.min(to) - 0.5 * width, from.max(to) + 0.5 * width);
        self.paint_between(colour, first, last, |at| {
            let part = ((at - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let beyond = (at - from).dot(along) / along.length();
            let side = 0.5 * width - at.distance(from + part * along);
            side.min(beyond).min(along.length() - beyond)
        });
    }

    /// Paints as [`Self::paint`] a shape that lies between two corners of the image.
    fn paint_between(&mut self, colour: Pixel, first: Vec2, last: Vec2, inside: impl Fn(Vec2) -> f32) {
        let (new, width) = (parts(colour), usize::from(self.width));
        // The edge is blurred by half a pixel.
        let range = |first: f32, last: f32, end: u16| {
            (first - 1.0).max(0.0) as usize..((last + 2.0).max(0.0) as usize).min(end.into())
        };
        let columns = range(first.x, last.x, self.width);
        for row in range(first.y, last.y, self.height) {
            for column in columns.clone() {
                let cover = (inside(Vec2::new(column as f32, row as f32)) + 0.5).clamp(0.0, 1.0);
                let pixel = &mut self.pixels[row * width + column];
                *pixel += cover * (new - *pixel);
            }
        }
    }

    /// Bytes of the frame; each pair has the mean chroma of its pixels.
    pub(crate) fn yuyv(&self) -> Vec<u8> {
        let byte = |value: f32, index: usize| {
            let noise = (index * 7919 % 7) as f32 - 3.0;
            (value + noise).round().clamp(0.0, 255.0) as u8
        };
        let mut bytes = Vec::with_capacity(2 * self.pixels.len());
        for [a, b] in self.pixels.as_chunks().0 {
            for value in [a.x, 0.5 * (a.y + b.y), b.x, 0.5 * (a.z + b.z)] {
                bytes.push(byte(value, bytes.len()));
            }
        }
        bytes
    }

    /// Calls a function with the frame.
    pub(crate) fn with_frame<T>(&self, with: impl FnOnce(&Frame<'_>) -> T) -> T {
        with(&Frame::new(self.width, self.height, &self.yuyv()).expect("a frame"))
    }
}

fn parts(pixel: Pixel) -> Vec3 {
    Vec3::new(pixel.y.into(), pixel.cb.into(), pixel.cr.into())
}
