//! Lines, circles, rectangles and polygons.

use glam::Vec2;

use super::canvas::{Area, Canvas, Ink};

impl Canvas {
    /// Draws a filled circle.
    pub fn disc(&mut self, centre: Vec2, radius: f32, ink: impl Into<Ink>) {
        self.paint(Area::around(&[centre], radius + 1.0), ink.into(), |p| p.distance(centre) - radius);
    }

    /// Draws a circle with a pen of `width`.
    pub fn ring(&mut self, centre: Vec2, radius: f32, width: f32, ink: impl Into<Ink>) {
        let area = Area::around(&[centre], radius + width + 1.0);
        self.paint(area, ink.into(), |p| (p.distance(centre) - radius).abs() - 0.5 * width);
    }

    /// Draws a straight line with round ends.
    pub fn line(&mut self, from: Vec2, to: Vec2, width: f32, ink: impl Into<Ink>) {
        let area = Area::around(&[from, to], width + 1.0);
        self.paint(area, ink.into(), |p| to_segment(p, from, to) - 0.5 * width);
    }

    /// Draws straight lines from point to point. Translucent ink is blended twice where two lines meet.
    pub fn polyline(&mut self, points: &[Vec2], width: f32, ink: impl Into<Ink>) {
        let ink = ink.into();
        for pair in points.windows(2) {
            self.line(pair[0], pair[1], width, ink);
        }
    }

    /// Draws a straight line in dashes of `dash` px, with gaps of the same length.
    pub fn dashed(&mut self, from: Vec2, to: Vec2, width: f32, dash: f32, ink: impl Into<Ink>) {
        let (ink, length) = (ink.into(), from.distance(to));
        let along = (to - from).normalize_or_zero();
        for step in 0..(length / (2.0 * dash)).ceil().min(1e4) as usize {
            let start = 2.0 * dash * step as f32;
            self.line(from + along * start, from + along * (start + dash).min(length), width, ink);
        }
    }

    /// Draws a dashed circle.
    pub fn dashed_ring(&mut self, centre: Vec2, radius: f32, width: f32, ink: impl Into<Ink>) {
        let dashes = (radius * 0.6).clamp(6.0, 60.0).round();
        let area = Area::around(&[centre], radius + width + 1.0);
        self.paint(area, ink.into(), |p| {
            let turn = (p - centre).to_angle() / std::f32::consts::TAU * dashes;
            let gap = ((turn - turn.floor() - 0.5).abs() - 0.28) * std::f32::consts::TAU * radius / dashes;
            ((p.distance(centre) - radius).abs() - 0.5 * width).max(gap)
        });
    }

    /// Draws a filled polygon, convex or not.
    pub fn polygon(&mut self, corners: &[Vec2], ink: impl Into<Ink>) {
        if corners.len() > 2 {
            self.paint(Area::around(corners, 1.0), ink.into(), |p| to_polygon(p, corners));
        }
    }

    /// Draws a filled rectangle with round corners.
    pub fn rounded_rectangle(&mut self, area: Area, radius: f32, ink: impl Into<Ink>) {
        let margin = Area { from: area.from - 1.0, to: area.to + 1.0 };
        self.paint(margin, ink.into(), |p| to_rounded_rectangle(p, area, radius));
    }

    /// Draws the outline of a rectangle with round corners; the pen stays inside.
    pub fn outline(&mut self, area: Area, radius: f32, width: f32, ink: impl Into<Ink>) {
        self.paint(area, ink.into(), |p| (to_rounded_rectangle(p, area, radius) + 0.5 * width).abs() - 0.5 * width);
    }

    /// Draws an arrow head with its tip at `tip`.
    pub fn arrow_head(&mut self, tip: Vec2, direction: Vec2, size: f32, ink: impl Into<Ink>) {
        let back = tip - direction.normalize_or_zero() * size;
        let aside = direction.normalize_or_zero().perp() * size * 0.45;
        self.polygon(&[tip, back + aside, back - aside], ink);
    }
}

fn to_segment(p: Vec2, from: Vec2, to: Vec2) -> f32 {
    let (along, reach) = (to - from, p - from);
    let part = (reach.dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
    reach.distance(along * part)
}

fn to_polygon(p: Vec2, corners: &[Vec2]) -> f32 {
    let (mut nearest, mut inside) = (f32::INFINITY, false);
    for (index, &from) in corners.iter().enumerate() {
        let to = corners[(index + 1) % corners.len()];
        nearest = nearest.min(to_segment(p, from, to));
        let crosses = (from.y > p.y) != (to.y > p.y);
        if crosses && p.x < (to.x - from.x) * (p.y - from.y) / (to.y - from.y) + from.x {
            inside = !inside;
        }
    }
    if inside { -nearest } else { nearest }
}

fn to_rounded_rectangle(p: Vec2, area: Area, radius: f32) -> f32 {
    let half = 0.5 * (area.to - area.from) - radius;
    let beyond = (p - area.centre()).abs() - half;
    beyond.max(Vec2::ZERO).length() + beyond.max_element().min(0.0) - radius
}
