//! A picture in memory.

use glam::Vec2;

/// Red, green and blue, 0 to 255 each.
pub type Rgb = [u8; 3];

/// Colour with opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// Red, green, blue.
    pub rgb: Rgb,
    /// Opacity, 0 to 1.
    pub alpha: f32,
}

impl From<Rgb> for Ink {
    fn from(rgb: Rgb) -> Self {
        Self { rgb, alpha: 1.0 }
    }
}

/// Axis-aligned rectangle, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Upper left corner.
    pub from: Vec2,
    /// Lower right corner.
    pub to: Vec2,
}

impl Area {
    /// A rectangle by its upper left corner and its size.
    #[must_use]
    pub const fn sized(x: f32, y: f32, width: f32, height: f32) -> Self {
        Self { from: Vec2::new(x, y), to: Vec2::new(x + width, y + height) }
    }

    /// The bounding box of points, enlarged by `margin` on each side.
    #[must_use]
    pub fn around(points: &[Vec2], margin: f32) -> Self {
        let from = points.iter().fold(Vec2::INFINITY, |low, p| low.min(*p));
        let to = points.iter().fold(Vec2::NEG_INFINITY, |high, p| high.max(*p));
        Self { from: from - margin, to: to + margin }
    }

    /// The centre.
    #[must_use]
    pub fn centre(&self) -> Vec2 {
        0.5 * (self.from + self.to)
    }
}

/// Picture: pixels in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

impl Canvas {
    /// A picture of one colour.
    #[must_use]
    pub fn new(width: usize, height: usize, paper: Rgb) -> Self {
        Self { width, height, pixels: vec![paper; width * height] }
    }

    /// Width, px.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Height, px.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.height
    }

    /// Red, green, blue of every pixel, row by row.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// Sets one pixel; pixels outside the canvas are ignored.
    pub fn set(&mut self, x: usize, y: usize, rgb: Rgb) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = rgb;
        }
    }

    /// Blends ink into one pixel; `cover`: share of the pixel inside the shape, 0 to 1.
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

    /// Fills a shape, given by its signed distance in px (negative inside), with anti-aliased edges. `area` contains it.
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

    /// Copies a canvas onto this one, with its upper left corner at (x, y).
    pub fn place(&mut self, other: &Self, x: usize, y: usize) {
        for row in 0..other.height {
            for column in 0..other.width {
                self.set(x + column, y + row, other.pixels[row * other.width + column]);
            }
        }
    }
}

/// Range of pixels from `from` to `to` on a canvas of `size`; none for values that are not finite.
fn pixels(from: f32, to: f32, size: usize) -> Option<std::ops::Range<i32>> {
    (from.is_finite() && to.is_finite())
        .then(|| (from.floor().max(0.0) as i32)..(to.ceil().clamp(0.0, size as f32) as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn disc_covers_its_area() {
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
    fn translucent_ink_is_blended_with_pixels_below() {
        let mut canvas = Canvas::new(4, 4, [100, 0, 200]);
        canvas.rounded_rectangle(Area::sized(0.0, 0.0, 2.0, 4.0), 0.0, Ink { rgb: [200, 200, 200], alpha: 0.5 });
        assert_eq!(canvas.bytes()[..3], [150, 100, 200]);
        assert_eq!(canvas.bytes()[9..12], [100, 0, 200]);
    }
}
