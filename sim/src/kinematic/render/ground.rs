//! The carpet with its lines, and the hall's floor around it.

use glam::Vec2;

use super::lines::LineMap;
use crate::camera::canvas::{Pixel, mix};
use crate::camera::light::Light;
use crate::camera::palette::{self, Palette, Rgb};
use crate::camera::pinhole::{LANES, Mapping, whole};
use crate::random::Random;

/// Side of the carpet's repeated pattern, points; a power of two.
const PATTERN: u32 = 256;
/// Points of the whole pattern.
const TUFTS: usize = (PATTERN * PATTERN) as usize;
/// Points of the pattern per metre.
const POINTS: f32 = 250.0;
/// Beyond this depth of a pixel on the ground lines are sampled several times, m.
const SAMPLE: f32 = 0.04;
/// The most samples of a pixel.
const MOST_SAMPLES: f32 = 4.0;
/// Even the nearest line's edge is this soft, m.
const SOFTNESS: f32 = 0.003;

/// Everything flat on the ground.
#[derive(Clone, Debug)]
pub(crate) struct Ground {
    lines: LineMap,
    /// Brightness of tufts, ± of 255.
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
            let column = whole(x[i] * POINTS) % PATTERN;
            let row = whole(y[i] * POINTS) % PATTERN;
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
        if self.lines.room_around(middle) > reach {
            return;
        }
        let samples = (spot.deep / SAMPLE).ceil().clamp(1.0, MOST_SAMPLES);
        if samples > 1.0 {
            return self.paint_far_lines(ground, (u, v), spot, samples, pixels);
        }
        let nearest = self.lines.nearest(x, y);
        let width = spot.side().max(spot.deep).max(SOFTNESS);
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let share = nearest.sure_share(i, width).unwrap_or_else(|| self.lines.share(x[i], y[i], width));
            self.mark(pixel, share);
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
            self.mark(pixel, share / samples);
        }
    }

    /// Paints a pixel of which a share shows a line.
    fn mark(&self, pixel: &mut Pixel, share: f32) {
        if share > 0.0 {
            *pixel = mix(*pixel, self.line, (share * 256.0) as i32);
        }
    }
}

/// How much of the ground a pixel shows: to the side and in depth, m.
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

/// Fine grain over soft blotches.
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
