//! Crossings of field lines.

use core::f32::consts::{FRAC_PI_2, PI};

use glam::Vec2;

use crate::FieldDimensions;

/// Shape of a crossing of two lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingKind {
    /// Both lines end at the crossing: a corner.
    L,
    /// One line ends at the other.
    T,
    /// Neither line ends.
    X,
}

/// A crossing of two field lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Shape.
    pub kind: CrossingKind,
    /// Intersection of the line centres, field frame, m.
    pub position: Vec2,
    /// Direction of one line, rad, counter-clockwise from x: an L continues at this heading and 90° left of it, a T
    /// at this heading and 90° to both sides, an X in all four directions.
    pub heading: f32,
}

impl Crossing {
    const fn new(kind: CrossingKind, position: Vec2, heading: f32) -> Self {
        Self { kind, position, heading }
    }
}

impl FieldDimensions {
    /// Half of the field's crossings. A turn of 180° about the centre mark gives the others.
    #[must_use]
    #[inline]
    pub const fn half_crossings(&self) -> [Crossing; 8] {
        let (corner, area) = (self.field_corner(), self.penalty_area_corner());
        [
            Crossing::new(CrossingKind::L, corner, PI),
            Crossing::new(CrossingKind::L, Vec2::new(corner.x, -corner.y), FRAC_PI_2),
            Crossing::new(CrossingKind::L, area, -FRAC_PI_2),
            Crossing::new(CrossingKind::L, Vec2::new(area.x, -area.y), 0.0),
            Crossing::new(CrossingKind::T, Vec2::new(corner.x, area.y), PI),
            Crossing::new(CrossingKind::T, Vec2::new(corner.x, -area.y), PI),
            Crossing::new(CrossingKind::T, Vec2::new(0.0, corner.y), -FRAC_PI_2),
            Crossing::new(CrossingKind::X, Vec2::new(0.0, self.centre_circle_radius()), 0.0),
        ]
    }
}
