//! Judgement of one repetition.

use bica::prelude::*;

use super::{Example, Repetition};

/// When a repetition is judged, and what is correct.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Judging {
    /// How far the arm may stay below the least peak of the examples.
    #[param(default = 10.0, range = 0.0..=90.0, unit = "°", step = 1.0)]
    pub too_low: f32,
    /// How far the trunk may lean beyond the largest lean of the examples.
    #[param(default = 1.5, range = 0.0..=45.0, unit = "°", step = 0.25)]
    pub leaning: f32,
    /// Largest angle between the plane of the movement and that of the examples.
    #[param(default = 16.0, range = 0.0..=90.0, unit = "°", step = 1.0)]
    pub direction: f32,
    /// Least share of the duration of the examples; 0: the tempo is not judged.
    #[param(default = 0.5, range = 0.0..=1.0, step = 0.05)]
    pub tempo: f32,
    /// Least confidence in a point of the skeleton.
    #[param(default = 0.5, range = 0.0..=1.0, step = 0.05)]
    pub confidence: f32,
    /// Least share of the skeletons in which trunk and arm must be seen.
    #[param(default = 0.6, range = 0.0..=1.0, step = 0.05)]
    pub seen: f32,
    /// Largest noise of the direction of the trunk.
    #[param(default = 5.0, range = 0.5..=20.0, unit = "°", step = 0.5)]
    pub noise: f32,
    /// Age from which a skeleton is old.
    #[param(default = 0.5, range = 0.1..=5.0, unit = "s", step = 0.1)]
    pub age: f32,
}

/// Least number of skeletons of a repetition that is judged.
const FEWEST: u32 = 8;

/// Judgement of a repetition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Correct,
    Incorrect,
    /// The person was not seen well enough, or there are no examples. The repetition does not count as incorrect.
    CannotTell,
}

impl Verdict {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Correct => "correct",
            Self::Incorrect => "incorrect",
            Self::CannotTell => "cannot_tell",
        }
    }
}

/// Reasons why a repetition is not correct or cannot be judged; all false for a correct one.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each reason holds or not, in any combination")]
pub struct Reasons {
    /// The arm stayed too low.
    pub too_low: bool,
    /// The trunk leaned.
    pub leaning: bool,
    /// The arm moved in another plane.
    pub wrong_direction: bool,
    /// The repetition was too short.
    pub too_fast: bool,
    /// Trunk or arm was not seen, or there were too few skeletons.
    pub not_seen: bool,
    /// The skeleton was too noisy.
    pub unsure: bool,
    /// There are no examples of this person.
    pub no_examples: bool,
}

impl Reasons {
    /// Names of the reasons that apply.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let all = [
            (self.too_low, "too low"),
            (self.leaning, "leaning"),
            (self.wrong_direction, "wrong direction"),
            (self.too_fast, "too fast"),
            (self.not_seen, "not seen"),
            (self.unsure, "unsure"),
            (self.no_examples, "no examples"),
        ];
        all.into_iter().filter_map(|(holds, name)| holds.then_some(name))
    }

    /// Verdict that follows from the reasons.
    pub(crate) fn verdict(self) -> Verdict {
        if self.not_seen || self.unsure || self.no_examples {
            Verdict::CannotTell
        } else if self == Self::default() {
            Verdict::Correct
        } else {
            Verdict::Incorrect
        }
    }
}

/// A repetition that was judged.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// Reasons why it is not correct.
    pub reasons: Reasons,
    /// Largest angle of the arm, degrees.
    pub peak: f32,
    /// Angle that suffices, degrees.
    pub goal: f32,
}

impl Judging {
    /// Judges a repetition against the examples of the same person.
    pub(crate) fn judge(&self, example: &Example, repetition: &Repetition) -> Reasons {
        let Repetition { seen, missed, noise, .. } = *repetition;
        let not_seen = seen < FEWEST || (seen as f32) < self.seen * (seen + missed) as f32;
        let unsure = noise > self.noise;
        if not_seen || unsure {
            return Reasons { not_seen, unsure, ..Reasons::default() };
        }
        let normal = example.reference.normal.unwrap_or(repetition.normal);
        Reasons {
            too_low: repetition.peak < example.peak - self.too_low,
            leaning: repetition.lean > example.lean + self.leaning,
            wrong_direction: repetition.normal.angle_between(normal).to_degrees() > self.direction,
            too_fast: repetition.seconds < self.tempo * example.seconds,
            ..Reasons::default()
        }
    }
}
