//! Texture of the carpet with its lines and of the floor around it.

use glam::Vec2;

use super::lines::LineMap;
use crate::camera::canvas::{Pixel, mix};
use crate::camera::light::Light;
use crate::camera::palette::{self, Palette, Rgb};
use crate::camera::pinhole::{LANES, Mapping, round_wrapping};
use crate::random::Random;

/// Side of the carpet's periodic texture, points; a power of two.
const PATTERN: u32 = 256;
/// Number of points of the texture.
const TUFTS: usize = (PATTERN * PATTERN) as usize;
/// Resolution of the texture, points per metre.
const POINTS: f32 = 250.0;
/// Depth of a pixel on the ground beyond which lines are supersampled, m.
const SAMPLE_DEPTH: f32 = 0.04;
/// Maximum number of samples of a pixel.
const MAX_SAMPLES: f32 = 4.0;
/// Minimum width of the transition at a line's edge, m.
const MIN_EDGE_WIDTH: f32 = 0.003;

/// Texture and colours of the ground.
#[derive(Clone, Debug)]
pub(crate) struct Ground {
    lines: LineMap,
    /// Luma offset of the tufts, counts of 255.
    pattern: Vec<i8>,
    carpet: Pixel,
    line: Pixel,
    floor: Pixel,
    light: Light,
}

impl Ground {
    pub(crate) fn new(palette: &Palette, light: Light, random: &mut Random) -> Self {
        let floors = [Rgb::new(0.42, 0.40, 0.38), Rgb::new(0.45, 0.33, 0.22), Rgb::new(0.28, 0.29, 0.31)];
        Self {
            lines: LineMap::new(),
            pattern: tufts(random),
            carpet: palette.pixel(palette::CARPET),
            line: palette.pixel(palette::LINE),
            floor: palette.pixel(floors[random.below(floors.len())]),
            light,
        }
    }

    /// Paints pixels of a row that show the carpet.
    pub(crate) fn paint_carpet(&self, ground: &Mapping, v: usize, first: usize, pixels: &mut [Pixel]) {
        for (i, pixels) in pixels.chunks_mut(LANES).enumerate() {
            let u = (first + i * LANES) as f32;
            let places = ground.row(u, v as f32);
            let spot = Spot::new(ground, u + pixels.len() as f32 / 2.0, v as f32);
            self.paint_tufts(self.carpet, &places, &spot, pixels);
            self.paint_lines(ground, (u, v as f32), &places, &spot, pixels);
        }
    }

    /// Paints pixels of a row that show the floor around the carpet.
    pub(crate) fn paint_floor(&self, ground: &Mapping, v: usize, first: usize, pixels: &mut [Pixel]) {
        for (i, pixels) in pixels.chunks_mut(LANES).enumerate() {
            let u = (first + i * LANES) as f32;
            let spot = Spot::new(ground, u + pixels.len() as f32 / 2.0, v as f32);
            self.paint_tufts(self.floor, &ground.row(u, v as f32), &spot, pixels);
        }
    }

    fn paint_tufts(&self, colour: Pixel, (x, y): &([f32; LANES], [f32; LANES]), spot: &Spot, pixels: &mut [Pixel]) {
        let slope = self.light.slope;
        let light = 1.0 + slope.0 * x[0].clamp(-6.0, 6.0) + slope.1 * y[0].clamp(-6.0, 6.0);
        let luma = (colour[0] as f32 * light) as i32;
        let contrast = (256.0 * (1.0 / (POINTS * spot.side())).min(1.0)) as i32;
        let mut places = [0; LANES];
        for i in 0..LANES {
            let column = round_wrapping(x[i] * POINTS) % PATTERN;
            let row = round_wrapping(y[i] * POINTS) % PATTERN;
            places[i] = row * PATTERN + column;
        }
        let tufts = places.map(|place| self.pattern[place as usize % TUFTS]);
        for (pixel, tuft) in pixels.iter_mut().zip(tufts) {
            let luma = luma + ((tuft as i32 * contrast) >> 8);
            *pixel = [luma.clamp(0, 255) as u8, colour[1], colour[2], 0];
        }
    }

    fn paint_lines(
        &self,
        ground: &Mapping,
        (u, v): (f32, f32),
        (x, y): &([f32; LANES], [f32; LANES]),
        spot: &Spot,
        pixels: &mut [Pixel],
    ) {
        let last = pixels.len() - 1;
        let [from, middle, to] = [0, last / 2, last].map(|i| Vec2::new(x[i], y[i]));
        let reach = middle.distance(from).max(middle.distance(to)) + spot.wide.max(spot.deep);
        if self.lines.clearance(middle) > reach {
            return;
        }
        let samples = (spot.deep / SAMPLE_DEPTH).ceil().clamp(1.0, MAX_SAMPLES);
        if samples > 1.0 {
            return self.paint_far_lines(ground, (u, v), spot, samples, pixels);
        }
        let nearest = self.lines.nearest(x, y);
        let width = spot.side().max(spot.deep).max(MIN_EDGE_WIDTH);
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let share = nearest.certain_share(i, width).unwrap_or_else(|| self.lines.share(x[i], y[i], width));
            self.blend_line(pixel, share);
        }
    }

    fn paint_far_lines(&self, ground: &Mapping, (u, v): (f32, f32), spot: &Spot, samples: f32, pixels: &mut [Pixel]) {
        let width = spot.wide.max(spot.deep / samples);
        let mut shares = [0.0; LANES];
        for sample in 0..samples as usize {
            let (x, y) = ground.row(u, v + (sample as f32 + 0.5) / samples - 0.5);
            self.lines.nearest(&x, &y).add_shares(width, &mut shares);
        }
        for (pixel, share) in pixels.iter_mut().zip(shares) {
            self.blend_line(pixel, share / samples);
        }
    }

    /// Blends the line colour into a pixel; `share`: covered fraction, 0 to 1.
    fn blend_line(&self, pixel: &mut Pixel, share: f32) {
        if share > 0.0 {
            *pixel = mix(*pixel, self.line, (share * 256.0) as i32);
        }
    }
}

/// Area of the ground shown by a pixel: width and depth, m.
struct Spot {
    wide: f32,
    deep: f32,
}

impl Spot {
    fn new(ground: &Mapping, u: f32, v: f32) -> Self {
        let here = ground.at(u, v);
        let size = |there: Vec2| here.distance(there).min(10.0);
        Self { wide: size(ground.at(u + 1.0, v)), deep: size(ground.at(u, v + 1.0)) }
    }

    fn side(&self) -> f32 {
        (self.wide * self.deep).sqrt()
    }
}

/// Draws a texture of fine noise over smooth blotches.
fn tufts(random: &mut Random) -> Vec<i8> {
    const SIDE: usize = PATTERN as usize;
    const BLOTCH: usize = 16;
    const BLOTCHES: usize = SIDE / BLOTCH;
    let blotches: Vec<f32> = (0..BLOTCHES * BLOTCHES).map(|_| 2.0 * random.normal()).collect();
    let blotch = |x: usize, y: usize| blotches[(y % BLOTCHES) * BLOTCHES + x % BLOTCHES];
    let smooth = |x: usize, y: usize| {
        let (column, row) = (x / BLOTCH, y / BLOTCH);
        let (right, up) = ((x % BLOTCH) as f32 / BLOTCH as f32, (y % BLOTCH) as f32 / BLOTCH as f32);
        let near = blotch(column, row) * (1.0 - right) + blotch(column + 1, row) * right;
        let far = blotch(column, row + 1) * (1.0 - right) + blotch(column + 1, row + 1) * right;
        near * (1.0 - up) + far * up
    };
    (0..TUFTS).map(|i| (smooth(i % SIDE, i / SIDE) + 7.0 * random.normal()).clamp(-30.0, 30.0) as i8).collect()
}
