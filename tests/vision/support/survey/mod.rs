//! Recall, precision and accuracy of all detectors over random poses in the built-in world.

pub(crate) mod detect;
mod field;
mod objects;
mod score;
mod truth;
mod view;

use std::fmt;

pub(crate) use score::Score;
use truth::Truth;
pub(crate) use view::View;

/// Maximum distance of due objects, m.
pub(crate) const FAR: f32 = 3.0;

/// Scores of all detectors.
pub(crate) struct Survey {
    pub(crate) poses: usize,
    pub(crate) ball: Score,
    pub(crate) posts: Score,
    pub(crate) lines: Score,
    pub(crate) crossings: Score,
    pub(crate) circle: Score,
    pub(crate) robots: Score,
    pub(crate) field_boundary: Score,
}

impl Survey {
    /// Evaluates `poses` random views, starting with number `first`.
    pub(crate) fn of(first: u64, poses: usize) -> Self {
        let mut survey = Self {
            poses: 0,
            ball: Score::new("ball", "% of distance"),
            posts: Score::new("goal posts", "% of distance"),
            lines: Score::new("lines (dm)", "cm off"),
            crossings: Score::new("crossings", "cm off"),
            circle: Score::new("centre circle", "cm off"),
            robots: Score::new("other robots", "cm off"),
            field_boundary: Score::new("field boundary", "rows off"),
        };
        for view in (first..).filter_map(View::new).take(poses) {
            survey.add(view);
        }
        survey
    }

    fn add(&mut self, mut view: View) {
        let truth = Truth::of(&mut view);
        let (_, seen) = detect::see(&view);
        self.poses += 1;
        self.ball.note(view.number, |score| objects::ball(score, &seen, &truth));
        self.posts.note(view.number, |score| objects::posts(score, &seen, &truth));
        self.robots.note(view.number, |score| objects::robots(score, &seen, &truth));
        self.lines.note(view.number, |score| field::lines(score, &seen, &truth));
        self.crossings.note(view.number, |score| field::crossings(score, &seen, &truth));
        self.circle.note(view.number, |score| field::circle(score, &seen, &truth));
        self.field_boundary.note(view.number, |score| field::end(score, &seen, &truth));
    }

    /// Scores in the order of the table.
    pub(crate) fn scores(&self) -> [&Score; 7] {
        [&self.ball, &self.posts, &self.lines, &self.crossings, &self.circle, &self.robots, &self.field_boundary]
    }
}

impl fmt::Display for Survey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} poses, 320×240; visible objects within {FAR} m are due", self.poses)?;
        writeln!(
            f,
            "{:17}{:>15}{:>9}{:>15}{:>11}   error",
            "", "found / due", "recall", "correct / found", "precision"
        )?;
        self.scores().into_iter().try_for_each(|score| writeln!(f, "{score}"))
    }
}
