//! Synthetic frames.

use bica_vision::frame::{Frame, Pixel};
use glam::Vec2;

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
    pixels: Vec<[f32; 3]>,
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
        let width = usize::from(self.width);
        for (index, pixel) in self.pixels.iter_mut().enumerate() {
            let at = Vec2::new((index % width) as f32, (index / width) as f32);
            let cover = (inside(at) + 0.5).clamp(0.0, 1.0);
            for (part, new) in pixel.iter_mut().zip(parts(colour)) {
                *part += cover * (new - *part);
            }
        }
    }

    pub(crate) fn disc(&mut self, colour: Pixel, centre: Vec2, radius: f32) {
        self.paint(colour, |at| radius - at.distance(centre));
    }

    /// Paints a straight bar between two points.
    pub(crate) fn bar(&mut self, colour: Pixel, from: Vec2, to: Vec2, width: f32) {
        let along = to - from;
        self.paint(colour, |at| {
            let part = ((at - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let beyond = (at - from).dot(along) / along.length();
            let side = 0.5 * width - at.distance(from + part * along);
            side.min(beyond).min(along.length() - beyond)
        });
    }

    /// Bytes of the frame; each pair has the mean chroma of its pixels.
    pub(crate) fn yuyv(&self) -> Vec<u8> {
        let byte = |value: f32, index: usize| {
            let noise = (index * 7919 % 7) as f32 - 3.0;
            (value + noise).round().clamp(0.0, 255.0) as u8
        };
        let pair = |(index, [a, b]): (usize, &[[f32; 3]; 2])| {
            let values = [a[0], 0.5 * (a[1] + b[1]), b[0], 0.5 * (a[2] + b[2])];
            [0, 1, 2, 3].map(|part| byte(values[part], 4 * index + part))
        };
        self.pixels.as_chunks::<2>().0.iter().enumerate().flat_map(pair).collect()
    }

    /// Calls a function with the frame.
    pub(crate) fn with_frame<T>(&self, with: impl FnOnce(&Frame<'_>) -> T) -> T {
        with(&Frame::new(self.width, self.height, &self.yuyv()).expect("a frame"))
    }
}

fn parts(pixel: Pixel) -> [f32; 3] {
    [pixel.y, pixel.cb, pixel.cr].map(f32::from)
}
