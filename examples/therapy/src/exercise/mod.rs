//! Counts the repetitions of an exercise and judges each against three correct ones of the same person.
//!
//! The check uses one upper arm and the trunk: how far the arm moves from its rest, in which plane, and how far the
//! trunk leans. It does not judge the rotation of a shoulder, which depth cameras measure badly. `docs/therapy.md`
//! explains the choice of the limits.

mod check;
mod counter;
mod example;
mod judgement;
mod posture;
mod repetition;

pub use judgement::{Attempt, Reasons};

pub(crate) use check::ExerciseCheck;
pub(crate) use counter::{Counter, Reference};
pub(crate) use example::{EXAMPLES, Example, Learner};
pub(crate) use judgement::{Judging, Verdict};
pub(crate) use posture::{Posture, Seen};
pub(crate) use repetition::Repetition;
