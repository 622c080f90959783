//! Position relative to the robot, as data and as text.

use glam::Vec2;
use serde::Serialize;

/// Position relative to the robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Polar {
    /// Distance on the ground, m.
    pub distance: f32,
    /// Direction, degrees, positive to the left.
    pub direction: f32,
    /// Whether the newest image shows the object; otherwise the position is remembered.
    pub seen: bool,
}

impl Polar {
    /// Converts a position in the robot's frame, m.
    #[must_use]
    pub fn new(at: Vec2, seen: bool) -> Self {
        Self { distance: at.length(), direction: at.to_angle().to_degrees(), seen }
    }
}

/// Format `1.10 m  12° left`, in parentheses if the position is remembered.
impl std::fmt::Display for Polar {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let degrees = self.direction.round() as i32;
        let side = match degrees {
            0 => "ahead",
            1.. => "left",
            _ => "right",
        };
        let text = format!("{:.2} m {:>3}° {side}", self.distance, degrees.abs());
        if self.seen { write!(out, " {text} ") } else { write!(out, "({text})") }
    }
}

/// Returns the text of a position; a dash if the position is unknown.
#[must_use]
pub fn describe(position: Option<Polar>) -> String {
    position.map_or_else(|| " -".to_owned(), |position| position.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_gives_distance_angle_and_side() {
        let text = |x, y, seen| Polar::new(Vec2::new(x, y), seen).to_string();
        assert_eq!(text(1.0, 0.0, true), " 1.00 m   0° ahead ");
        assert_eq!(text(1.0, 1.0, true), " 1.41 m  45° left ");
        assert_eq!(text(0.0, -2.0, false), "(2.00 m  90° right)");
        assert_eq!(describe(None), " -");
    }
}
