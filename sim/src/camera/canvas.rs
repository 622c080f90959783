//! YCbCr canvas for convex polygons.

use glam::Vec2;

/// Luma, blue and red chroma (128 is grey), and a padding byte.
pub(crate) type Pixel = [u8; 4];

/// Number of pixels that are painted together at an edge.
const CHUNK: usize = 16;

/// Pixels of a picture, rows from the top.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) pixels: Vec<Pixel>,
}

/// Rendering of a polygon's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    /// Antialiased: pixels that are partly covered are blended with the background.
    Soft,
    /// Pixels that are partly covered are painted completely, so that adjacent polygons leave no gap.
    Hard,
}

/// An interval of a row, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    from: f32,
    to: f32,
}

impl Span {
    /// Returns the fraction of a pixel inside the interval.
    fn covers(self, u: usize) -> f32 {
        let u = u as f32;
        ((u + 0.5).min(self.to) - (u - 0.5).max(self.from)).max(0.0)
    }
}

impl Canvas {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![[0, 128, 128, 0]; width * height] }
    }

    /// Returns the pixels of a row.
    pub(crate) fn row(&mut self, v: usize) -> &mut [Pixel] {
        &mut self.pixels[v * self.width..][..self.width]
    }

    /// Paints a convex polygon. `paint` receives the row, the column of the first pixel and the current pixels, and replaces
    /// them by the colours of a completely covered pixel.
    pub(crate) fn fill(&mut self, polygon: &[Vec2], edge: Edge, mut paint: impl FnMut(usize, usize, &mut [Pixel])) {
        let lowest = polygon.iter().fold(f32::NEG_INFINITY, |most, corner| most.max(corner.y));
        let highest = polygon.iter().fold(f32::INFINITY, |least, corner| least.min(corner.y));
        let first = (highest - 0.5).max(0.0) as usize;
        let last = (lowest + 0.5).min(self.height as f32 - 1.0);
        if polygon.len() < 3 || last < 0.0 {
            return;
        }
        for v in first..=last as usize {
            let y = v as f32;
            let lines = [cut(polygon, y - 0.25), cut(polygon, y + 0.25)];
            let Some(outer) = both(lines, f32::min, f32::max) else { continue };
            let last_column = (outer.to + 0.5).min(self.width as f32 - 1.0);
            let first_column = (outer.from + 0.5).max(0.0);
            if first_column > last_column {
                continue;
            }
            let columns = (first_column as usize, last_column as usize + 1);
            match edge {
                Edge::Hard => paint(v, columns.0, &mut self.row(v)[columns.0..columns.1]),
                Edge::Soft => soft_row(self.row(v), v, columns, lines, &mut paint),
            }
        }
    }
}

/// Returns the interval of the horizontal line at `y` inside a polygon.
fn cut(polygon: &[Vec2], y: f32) -> Option<Span> {
    let mut span = Span { from: f32::INFINITY, to: f32::NEG_INFINITY };
    let mut a = polygon[polygon.len() - 1];
    for &b in polygon {
        if (a.y <= y) != (b.y <= y) {
            let x = a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y);
            span.from = span.from.min(x);
            span.to = span.to.max(x);
        }
        a = b;
    }
    (span.from <= span.to).then_some(span)
}

/// Combines the intervals of two lines; with only one of them, returns it.
fn both(lines: [Option<Span>; 2], from: fn(f32, f32) -> f32, to: fn(f32, f32) -> f32) -> Option<Span> {
    match lines {
        [Some(a), Some(b)] => Some(Span { from: from(a.from, b.from), to: to(a.to, b.to) }),
        [one, other] => one.or(other),
    }
}

/// Paints the antialiased columns `first` to `end` of a row that the intervals `lines` cover.
fn soft_row(
    row: &mut [Pixel],
    v: usize,
    (first, end): (usize, usize),
    lines: [Option<Span>; 2],
    paint: &mut impl FnMut(usize, usize, &mut [Pixel]),
) {
    let inner = if lines.iter().all(Option::is_some) { both(lines, f32::max, f32::min) } else { None };
    let (full, full_end) = inner.map_or((end, end), |inner| {
        let full = ((inner.from + 1.5).max(first as f32) as usize).min(end);
        (full, ((inner.to + 0.5).max(0.0) as usize).clamp(full, end))
    });
    if full < full_end {
        paint(v, full, &mut row[full..full_end]);
    }
    for (from, to) in [(first, full), (full_end, end)] {
        for start in (from..to).step_by(CHUNK) {
            let stop = (start + CHUNK).min(to);
            let mut painted = [[0; 4]; CHUNK];
            let painted = &mut painted[..stop - start];
            painted.copy_from_slice(&row[start..stop]);
            paint(v, start, painted);
            for (i, (there, new)) in row[start..stop].iter_mut().zip(painted).enumerate() {
                let covered: f32 = lines.iter().flatten().map(|span| span.covers(start + i)).sum();
                *there = mix(*there, *new, (covered * 128.0) as i32);
            }
        }
    }
}

/// Blends two colours; `share`: weight of `to`, of 256.
pub(crate) fn mix(from: Pixel, to: Pixel, share: i32) -> Pixel {
    core::array::from_fn(|i| (from[i] as i32 + (((to[i] as i32 - from[i] as i32) * share + 128) >> 8)) as u8)
}

/// Scales the brightness of a colour by `light` / 256.
pub(crate) fn lit([y, cb, cr, _]: Pixel, light: i32) -> Pixel {
    let chroma = |c: u8| (128 + (((c as i32 - 128) * light) >> 8)).clamp(0, 255) as u8;
    [((y as i32 * light) >> 8).clamp(0, 255) as u8, chroma(cb), chroma(cr), 0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, Stream};

    fn painted(polygon: &[Vec2], edge: Edge) -> Canvas {
        let mut canvas = Canvas::new(64, 48);
        canvas.fill(polygon, edge, |_, _, pixels| pixels.fill([200, 128, 128, 0]));
        canvas
    }

    fn area(canvas: &Canvas) -> f32 {
        canvas.pixels.iter().map(|pixel| pixel[0] as f32 / 200.0).sum()
    }

    #[test]
    fn soft_polygon_covers_its_area_around_its_centroid() {
        let mut random = Random::new(11, Stream::Start);
        for _ in 0..200 {
            let centre = Vec2::new(random.between(20.0, 44.0), random.between(16.0, 32.0));
            let radius = random.between(2.0, 12.0);
            let corners: Vec<Vec2> =
                (0..24).map(|i| centre + radius * bica_motion::pose::rotate(Vec2::X, i as f32 * 0.2618)).collect();
            let canvas = painted(&corners, Edge::Soft);
            let expected = 12.0 * radius * radius * 0.2618_f32.sin();
            assert!((area(&canvas) - expected).abs() < 0.01 * expected + 0.3, "{} {expected}", area(&canvas));
            let moment: Vec2 = (canvas.pixels.iter().enumerate())
                .map(|(i, pixel)| Vec2::new((i % 64) as f32, (i / 64) as f32) * (pixel[0] as f32 / 200.0))
                .sum();
            assert!((moment / area(&canvas)).distance(centre) < 0.1);
        }
    }

    #[test]
    fn adjacent_hard_polygons_leave_no_gap() {
        let mut random = Random::new(12, Stream::Start);
        for _ in 0..200 {
            let (top, bottom) = (random.between(-20.0, 80.0), random.between(-20.0, 80.0));
            let (a, b) = (Vec2::new(top, -5.0), Vec2::new(bottom, 60.0));
            let left = [Vec2::new(-500.0, -5.0), a, b, Vec2::new(-500.0, 60.0)];
            let right = [a, Vec2::new(500.0, -5.0), Vec2::new(500.0, 60.0), b];
            let mut canvas = painted(&left, Edge::Hard);
            canvas.fill(&right, Edge::Hard, |_, _, pixels| pixels.fill([200, 128, 128, 0]));
            assert!(canvas.pixels.iter().all(|pixel| pixel[0] == 200));
        }
    }

    #[test]
    fn degenerate_polygons_paint_almost_nothing() {
        let far = [Vec2::new(-50.0, -50.0), Vec2::new(-10.0, -50.0), Vec2::new(-10.0, -20.0)];
        assert_eq!(area(&painted(&far, Edge::Soft)), 0.0);
        let line = [Vec2::new(5.0, 5.0), Vec2::new(30.0, 20.0), Vec2::new(5.0, 5.0)];
        assert!(area(&painted(&line, Edge::Soft)) < 1.0);
        assert_eq!(area(&painted(&[], Edge::Hard)), 0.0);
        let huge = [Vec2::new(-1e9, -1e9), Vec2::new(1e9, -1e9), Vec2::new(0.0, 1e9)];
        assert!(area(&painted(&huge, Edge::Soft)) > 64.0 * 48.0 - 200.0);
    }
}
