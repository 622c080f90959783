//! Where something is, in words and as data.

use glam::Vec2;
use serde::Serialize;

/// Where something is, seen from the robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sight {
    /// m.
    pub distance: f32,
    /// Degrees, positive to the left.
    pub direction: f32,
    /// Whether it is in the newest image, or only remembered.
    pub seen: bool,
}

impl Sight {
    /// From a place in the robot's own frame, m.
    pub fn new(at: Vec2, seen: bool) -> Self {
        Self { distance: at.length(), direction: at.to_angle().to_degrees(), seen }
    }
}

/// `1.10 m  12° left`, in parentheses if it is only remembered.
impl std::fmt::Display for Sight {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let degrees = self.direction.round() as i32;
        let side = match degrees {
            0 => "ahead",
            1.. => "left",
            _ => "right",
        };
        let words = format!("{:.2} m {:>3}° {side}", self.distance, degrees.abs());
        if self.seen { write!(out, " {words} ") } else { write!(out, "({words})") }
    }
}

/// Words for what may not be known.
pub fn words(sight: Option<Sight>) -> String {
    sight.map_or_else(|| " -".to_owned(), |sight| sight.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_told_by_distance_and_side() {
        let told = |x, y, seen| Sight::new(Vec2::new(x, y), seen).to_string();
        assert_eq!(told(1.0, 0.0, true), " 1.00 m   0° ahead ");
        assert_eq!(told(1.0, 1.0, true), " 1.41 m  45° left ");
        assert_eq!(told(0.0, -2.0, false), "(2.00 m  90° right)");
        assert_eq!(words(None), " -");
    }
}
