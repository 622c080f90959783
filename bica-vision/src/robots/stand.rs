//! Obstacle in one column, from its foot upwards.

use super::RobotDetection;
use crate::colour::Colour;

/// Obstacle in one column during the scan.
pub(super) struct Stand {
    pub(super) base: f32,
    pub(super) top: f32,
    least: f32,
    counts: [f32; 3],
    green: f32,
    /// Number of green rows after which the obstacle has ended.
    max_green: f32,
}

impl Stand {
    pub(super) fn new(base: f32, least: f32, class: Colour, tuning: &RobotDetection) -> Self {
        let max_green = (tuning.max_green * least).max(2.0);
        let mut stand = Self { base, top: base, least, counts: [0.0; 3], green: 0.0, max_green };
        stand.add(class, base, tuning);
        stand
    }

    /// Adds the class of the next two rows. Returns whether the obstacle is a robot for certain.
    pub(super) fn add(&mut self, class: Colour, row: f32, tuning: &RobotDetection) -> bool {
        let [all, wrong, white] = &mut self.counts;
        *all += 2.0;
        match class {
            Colour::Green => self.green += 2.0,
            Colour::Yellow | Colour::Blue | Colour::Orange => *wrong += 2.0,
            Colour::White => *white += 2.0,
            Colour::None => {}
        }
        self.top = row;
        let is_high = self.base - row >= self.least;
        is_high && *wrong <= tuning.max_other_colours * *all && *white >= tuning.min_white * *all && !self.is_over()
    }

    /// Whether green continues behind the obstacle.
    pub(super) fn is_over(&self) -> bool {
        self.green > self.max_green
    }
}
