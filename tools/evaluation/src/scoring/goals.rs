//! Detected goals compared with labelled ones.

use glam::Vec2;
use serde::Serialize;

use super::tally::Share;
use crate::detection::{Detections, Goal};
use crate::labels;

/// Least intersection over union of a correct bounding box.
const MIN_OVERLAP: f32 = 0.6;

/// Figures of goals.
#[derive(Debug, Default, Serialize)]
pub(super) struct Goals {
    /// Images with a complete goal; good if a box overlaps it.
    pub(super) complete: Share,
    /// Images with a partial goal; good if a part is detected.
    pub(super) partial: Share,
    /// Images without a goal; good without a detection.
    pub(super) without: Share,
    /// Images with a complete goal that was missed or has a wrong box.
    pub(super) missed: Vec<String>,
    /// Images with a partial goal that was missed.
    pub(super) missed_partial: Vec<String>,
    /// Images with a detected goal that does not exist or has the other colour.
    pub(super) wrong: Vec<String>,
}

impl Goals {
    pub(super) fn count(&mut self, seen: &Detections, label: Option<&labels::Goal>) {
        let Some(label) = label else {
            self.without.count(seen.goals.is_empty());
            return self.note_wrong(seen, !seen.goals.is_empty());
        };
        let own = seen.goals.iter().find(|goal| goal.colour == label.colour);
        self.note_wrong(seen, seen.goals.iter().any(|goal| goal.colour != label.colour));
        let share = own.map_or(0.0, |goal| overlap(goal, label));
        let (list, missed, good) = if label.complete {
            (&mut self.complete, &mut self.missed, share >= MIN_OVERLAP)
        } else {
            (&mut self.partial, &mut self.missed_partial, own.is_some())
        };
        list.count(good);
        missed.extend((!good).then(|| format!("{} ({share:.2})", seen.file)));
    }

    fn note_wrong(&mut self, seen: &Detections, wrong: bool) {
        self.wrong.extend(wrong.then(|| seen.file.clone()));
    }
}

fn overlap(goal: &Goal, label: &labels::Goal) -> f32 {
    let (min, max) = (Vec2::new(goal.x0, goal.y0), Vec2::new(goal.x1, goal.y1));
    let area = |size: Vec2| size.x.max(0.0) * size.y.max(0.0);
    let common = area(max.min(label.max) - min.max(label.min));
    common / (area(max - min) + area(label.max - label.min) - common).max(1e-6)
}
