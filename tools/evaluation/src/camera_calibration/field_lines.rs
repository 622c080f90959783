//! The lines of the field, and distances to them.

use bica_field::FIELD;
use glam::Vec2;

/// Line of the field: the middle of its paint, field frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FieldLine {
    /// From one end to the other.
    Straight(Vec2, Vec2),
    /// The centre circle, by its radius.
    Circle(f32),
}

impl FieldLine {
    /// Returns all lines.
    pub(super) fn all() -> Vec<Self> {
        let (corner, area) = (FIELD.field_corner(), FIELD.penalty_area_corner());
        let mut lines = vec![
            Self::Circle(FIELD.centre_circle_radius()),
            Self::Straight(Vec2::new(0.0, -corner.y), Vec2::new(0.0, corner.y)),
        ];
        for side in [-1.0, 1.0] {
            let (end, front) = (side * corner.x, side * area.x);
            lines.push(Self::Straight(Vec2::new(-corner.x, side * corner.y), Vec2::new(corner.x, side * corner.y)));
            lines.push(Self::Straight(Vec2::new(end, -corner.y), Vec2::new(end, corner.y)));
            lines.push(Self::Straight(Vec2::new(front, -area.y), Vec2::new(front, area.y)));
            for y in [-area.y, area.y] {
                lines.push(Self::Straight(Vec2::new(front, y), Vec2::new(end, y)));
            }
        }
        lines
    }

    /// Distance from a point to the nearest point of the line, m.
    pub(super) fn distance(&self, point: Vec2) -> f32 {
        match *self {
            Self::Straight(from, to) => {
                let along = ((point - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
                point.distance(from.lerp(to, along))
            }
            Self::Circle(radius) => (point.length() - radius).abs(),
        }
    }

    /// Distance to the side from the line without ends, m, and its direction.
    pub(super) fn side(&self, point: Vec2) -> (f32, Vec2) {
        match *self {
            Self::Straight(from, to) => {
                let normal = (to - from).perp().normalize_or_zero();
                ((point - from).dot(normal), normal)
            }
            Self::Circle(radius) => (point.length() - radius, point.normalize_or_zero()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_line_is_as_far_as_the_field_says() {
        let lines = FieldLine::all();
        let mark = Vec2::new(FIELD.penalty_mark(), 0.0);
        for (x, y) in (-32..=32).flat_map(|x| (-22..=22).map(move |y| (x, y))) {
            let point = Vec2::new(x as f32, y as f32) / 10.0;
            let nearest = lines.iter().map(|line| line.distance(point)).fold(f32::MAX, f32::min);
            // Penalty marks and the bars of the goals are not lines of a calibration.
            let is_other = point.abs().distance(mark) < nearest || point.x.abs() > FIELD.field_corner().x;
            assert!(is_other || (nearest - FIELD.line_distance(point)).abs() < 1e-5, "{point}");
        }
    }
}
