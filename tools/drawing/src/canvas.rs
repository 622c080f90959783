//! A picture in memory, and how ink gets onto it.

use glam::Vec2;

/// Red, green and blue, 0 to 255 each.
pub type Rgb = [u8; 3];

/// A colour and how much of it covers what is below, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    pub rgb: Rgb,
    pub alpha: f32,
}

impl From<Rgb> for Ink {
    fn from(rgb: Rgb) -> Self {
        Self { rgb, alpha: 1.0 }
    }
}

/// An upright rectangle in pixels, y down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    pub from: Vec2,
    pub to: Vec2,
}

impl Area {
    /// From the upper left corner and a size.
    pub const fn sized(x: f32, y: f32, width: f32, height: f32) -> Self {
        Self { from: Vec2::new(x, y), to: Vec2::new(x + width, y + height) }
    }

    /// The smallest rectangle around points, grown by `margin`.
    pub fn around(points: &[Vec2], margin: f32) -> Self {
        let from = points.iter().fold(Vec2::INFINITY, |low, p| low.min(*p));
        let to = points.iter().fold(Vec2::NEG_INFINITY, |high, p| high.max(*p));
        Self { from: from - margin, to: to + margin }
    }

    /// The middle.
    pub fn centre(&self) -> Vec2 {
        0.5 * (self.from + self.to)
    }
}

/// Pixels in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

impl Canvas {
    /// An empty sheet of one colour.
    pub fn new(width: usize, height: usize, paper: Rgb) -> Self {
        Self { width, height, pixels: vec![paper; width * height] }
    }

    /// Width in pixels.
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Height in pixels.
    pub const fn height(&self) -> usize {
        self.height
    }

    /// Red, green, blue of every pixel, row by row.
    pub fn bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// Replaces one pixel; nothing happens outside the canvas.
    pub fn set(&mut self, x: usize, y: usize, rgb: Rgb) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = rgb;
        }
    }

    /// Lays ink over one pixel, of which `cover` (0 to 1) is inside the shape.
    pub fn blend(&mut self, x: i32, y: i32, ink: Ink, cover: f32) {
        let inside = (0..self.width as i32).contains(&x) && (0..self.height as i32).contains(&y);
        let part = ink.alpha * cover;
        if inside && part > 0.0 {
            let below = &mut self.pixels[y as usize * self.width + x as usize];
            for (old, new) in below.iter_mut().zip(ink.rgb) {
                *old = (f32::from(*old) + part * (f32::from(new) - f32::from(*old))).round() as u8;
            }
        }
    }

    /// Paints a shape given by its signed distance (negative inside), with smooth edges, within `area`.
    pub fn paint(&mut self, area: Area, ink: Ink, distance: impl Fn(Vec2) -> f32) {
        let (Some(columns), Some(rows)) =
            (pixels(area.from.x, area.to.x, self.width), pixels(area.from.y, area.to.y, self.height))
        else {
            return;
        };
        for y in rows {
            for x in columns.clone() {
                let cover = 0.5 - distance(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
                self.blend(x, y, ink, cover.clamp(0.0, 1.0));
            }
        }
    }

    /// Copies a whole canvas onto this one, its upper left corner at (x, y).
    pub fn place(&mut self, other: &Self, x: usize, y: usize) {
        for row in 0..other.height {
            for column in 0..other.width {
                self.set(x + column, y + row, other.pixels[row * other.width + column]);
            }
        }
    }
}

/// The pixels from `from` to `to` which lie on a canvas of `size`; none for what is no number.
fn pixels(from: f32, to: f32, size: usize) -> Option<std::ops::Range<i32>> {
    (from.is_finite() && to.is_finite())
        .then(|| (from.floor().max(0.0) as i32)..(to.ceil().clamp(0.0, size as f32) as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_covers_its_area_and_nothing_outside_the_canvas() {
        let mut canvas = Canvas::new(60, 40, [0; 3]);
        canvas.disc(Vec2::new(30.3, 20.6), 12.5, [255; 3]);
        let covered: f32 = canvas.bytes().iter().step_by(3).map(|value| f32::from(*value) / 255.0).sum();
        let area = std::f32::consts::PI * 12.5 * 12.5;
        assert!((covered - area).abs() < 0.01 * area, "{covered} of {area}");
        for centre in [Vec2::new(-40.0, 20.0), Vec2::splat(1e9), Vec2::NAN, Vec2::INFINITY] {
            let before = canvas.clone();
            canvas.disc(centre, 12.5, [9; 3]);
            canvas.line(centre, centre + 1.0, 3.0, [9; 3]);
            canvas.polygon(&[centre, centre + 1.0, centre - 2.0], [9; 3]);
            assert_eq!(canvas, before, "{centre}");
        }
    }

    #[test]
    fn ink_lets_through_what_it_does_not_cover() {
        let mut canvas = Canvas::new(4, 4, [100, 0, 200]);
        canvas.slab(Area::sized(0.0, 0.0, 2.0, 4.0), 0.0, Ink { rgb: [200, 200, 200], alpha: 0.5 });
        assert_eq!(canvas.bytes()[..3], [150, 100, 200]);
        assert_eq!(canvas.bytes()[9..12], [100, 0, 200]);
    }
}
