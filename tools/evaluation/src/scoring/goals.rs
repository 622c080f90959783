//! Seen goals against labelled ones.

use glam::Vec2;
use serde::Serialize;

use super::tally::Share;
use crate::detection::{Goal, Sighting};
use crate::labels;

/// The least overlap with which a box is that of a complete goal: intersection over union.
const OVERLAP: f32 = 0.6;

/// How many goals were right.
#[derive(Debug, Default, Serialize)]
pub struct Goals {
    /// Complete ones with a box that overlaps.
    pub complete: Share,
    /// Partial ones of which something was seen.
    pub partial: Share,
    /// Frames without a goal in which none was seen.
    pub without: Share,
    /// Complete goals that were missed, or whose box is wrong.
    pub missed: Vec<String>,
    /// Partial goals that were missed.
    pub missed_partial: Vec<String>,
    /// Frames with a goal that is not there, or not of that colour.
    pub wrong: Vec<String>,
}

impl Goals {
    pub fn count(&mut self, seen: &Sighting, label: Option<&labels::Goal>) {
        let Some(label) = label else {
            self.without.count(seen.goals.is_empty());
            return self.note_wrong(seen, !seen.goals.is_empty());
        };
        let own = seen.goals.iter().find(|goal| goal.colour == label.colour);
        self.note_wrong(seen, seen.goals.iter().any(|goal| goal.colour != label.colour));
        let share = own.map_or(0.0, |goal| overlap(goal, label));
        let (list, missed, good) = if label.complete {
            (&mut self.complete, &mut self.missed, share >= OVERLAP)
        } else {
            (&mut self.partial, &mut self.missed_partial, own.is_some())
        };
        list.count(good);
        missed.extend((!good).then(|| format!("{} ({share:.2})", seen.file)));
    }

    fn note_wrong(&mut self, seen: &Sighting, wrong: bool) {
        self.wrong.extend(wrong.then(|| seen.file.clone()));
    }
}

fn overlap(goal: &Goal, label: &labels::Goal) -> f32 {
    let (min, max) = (Vec2::new(goal.x0, goal.y0), Vec2::new(goal.x1, goal.y1));
    let area = |size: Vec2| size.x.max(0.0) * size.y.max(0.0);
    let common = area(max.min(label.max) - min.max(label.min));
    common / (area(max - min) + area(label.max - label.min) - common).max(1e-6)
}
