//! Component that counts and judges repetitions.

use bica::prelude::*;

use super::{Attempt, Counter, EXAMPLES, Example, Judging, Learner, Posture, Verdict};
use crate::input::PatientPose;

/// Counts the repetitions of a person and judges them. It first learns from three correct ones, which a therapist watches.
#[derive(Debug)]
pub struct ExerciseCheck {
    stage: Stage,
    /// Number of the last skeleton that was processed.
    taken: u32,
    /// Time since that skeleton, s.
    waited: f32,
    counts: Counts,
    attempts: [Option<Attempt>; NEWEST],
    /// A new repetition, to be written to the record.
    pub(crate) news: Option<Attempt>,
}

/// Number of repetitions that the page shows.
const NEWEST: usize = 10;

/// Stage of the check.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one check, and no memory to allocate from")]
enum Stage {
    Idle,
    Learning(Learner),
    Judging(Example, Counter),
}

/// Numbers of judged repetitions.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    /// Repetitions.
    pub(crate) repetitions: u16,
    /// Correct ones.
    pub(crate) correct: u16,
    /// Incorrect ones.
    pub(crate) incorrect: u16,
    /// Those that could not be judged.
    pub(crate) cannot_tell: u16,
}

#[component(hz = 50, budget_us = 200)]
impl ExerciseCheck {
    pub(crate) const fn new() -> Self {
        let counts = Counts { repetitions: 0, correct: 0, incorrect: 0, cannot_tell: 0 };
        Self { stage: Stage::Idle, taken: 0, waited: 0.0, counts, attempts: [None; NEWEST], news: None }
    }

    fn step(&mut self, tuned: &Tuned<Judging>, pose: &PatientPose, time: &Time) {
        self.waited += time.dt();
        let is_new = pose.number != self.taken;
        if !is_new && self.waited < tuned.age {
            return;
        }
        let posture = Posture::of(pose.skeleton.as_ref().filter(|_| is_new), tuned.confidence);
        self.take(posture.as_ref(), self.waited, tuned);
        (self.taken, self.waited) = (pose.number, 0.0);
    }

    fn take(&mut self, posture: Option<&Posture>, dt: f32, judging: &Judging) {
        let (example, ended) = match &mut self.stage {
            Stage::Idle => return,
            Stage::Learning(learner) => {
                learner.push(posture, dt);
                if let Some(example) = learner.example(EXAMPLES) {
                    self.stage = Stage::Judging(example, Counter::new(example.reference));
                }
                return;
            }
            Stage::Judging(example, counter) => {
                let seen = posture.and_then(|posture| posture.side(example.arm));
                (example, counter.push(seen, dt))
            }
        };
        let Some(repetition) = ended else { return };
        let reasons = judging.judge(example, &repetition);
        self.news = Some(Attempt { reasons, peak: repetition.peak, goal: example.peak - judging.too_low });
        self.attempts.rotate_left(1);
        self.attempts[NEWEST - 1] = self.news;
        self.counts.repetitions += 1;
        *match reasons.verdict() {
            Verdict::Correct => &mut self.counts.correct,
            Verdict::Incorrect => &mut self.counts.incorrect,
            Verdict::CannotTell => &mut self.counts.cannot_tell,
        } += 1;
    }

    /// Forgets the examples, and learns from the next three repetitions.
    #[modulation]
    pub(crate) fn learn(&mut self) {
        *self = Self { stage: Stage::Learning(Learner::new()), taken: self.taken, ..Self::new() };
    }

    /// Counts from 0, with the same examples.
    #[modulation]
    pub(crate) fn restart(&mut self) {
        if let Stage::Judging(example, counter) = &mut self.stage {
            *counter = Counter::new(example.reference);
        }
        (self.counts, self.attempts) = (Counts::default(), [None; NEWEST]);
    }

    /// Number of examples so far, 0 to 3.
    #[output]
    pub(crate) fn examples(&self) -> u8 {
        match &self.stage {
            Stage::Idle => 0,
            Stage::Learning(learner) => learner.repetitions() as u8,
            Stage::Judging(..) => EXAMPLES as u8,
        }
    }

    /// Numbers of repetitions since the examples.
    #[output]
    pub(crate) const fn counts(&self) -> Counts {
        self.counts
    }

    /// The newest repetitions since the examples; the last one at the end.
    #[output]
    pub(crate) const fn attempts(&self) -> [Option<Attempt>; NEWEST] {
        self.attempts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::skeleton::{POINTS, Person, Skeleton};

    /// Skeletons per second.
    const RATE: u32 = 20;

    const PERSON: Person = Person { peak: 100.0, lean: 1.0, plane: 0.0 };

    /// The check and the pose component with the newest skeleton.
    struct Room {
        check: ExerciseCheck,
        pose: PatientPose,
    }

    impl Room {
        /// A check that has learnt from three examples.
        fn new() -> Self {
            let mut room = Self { check: ExerciseCheck::new(), pose: PatientPose::new() };
            room.check.learn();
            (0..3).for_each(|_| room.repeat(PERSON, 2.0, 1));
            assert_eq!((room.check.examples(), room.check.counts().repetitions), (3, 0));
            room
        }

        fn pass(&mut self, skeleton: Option<Skeleton>) {
            if let Some(skeleton) = skeleton {
                self.pose.see(skeleton);
            }
            let since_run = Duration::from_millis(1000 / u64::from(RATE));
            let time = Time { now: Instant::from_millis(0), since_run, in_state: since_run };
            self.check.step(&Tuned::new(Judging::DEFAULT), &self.pose, &time);
        }

        /// Rests for 0.5 s, then raises and lowers the arm. One of `seen` skeletons is visible.
        fn repeat(&mut self, person: Person, seconds: f32, seen: u32) {
            (0..RATE / 2).for_each(|_| self.pass(Some(Person::STILL.at(0.0))));
            let frames = (seconds * RATE as f32) as u32;
            for frame in 0..=frames {
                let mut skeleton = person.at(libm::sinf(core::f32::consts::PI * frame as f32 / frames as f32));
                skeleton.confidence = [if frame % seen == 0 { 1.0 } else { 0.1 }; POINTS];
                self.pass(Some(skeleton));
            }
        }
    }

    #[test]
    fn a_repetition_is_judged_for_each_reason() {
        let (told, seconds) = (Verdict::Incorrect, 2.0);
        for (person, seconds, seen, verdict, reasons) in [
            (Person { peak: 98.0, lean: 1.5, plane: 10.0 }, 2.2, 1, Verdict::Correct, ""),
            (Person { peak: 80.0, ..PERSON }, seconds, 1, told, "too low"),
            (Person { lean: 8.0, ..PERSON }, seconds, 1, told, "leaning"),
            (Person { plane: 60.0, ..PERSON }, seconds, 1, told, "wrong direction"),
            (PERSON, 0.7, 1, told, "too fast"),
            (Person { peak: 80.0, ..PERSON }, seconds, 3, Verdict::CannotTell, "not seen"),
        ] {
            let mut room = Room::new();
            room.repeat(person, seconds, seen);
            room.repeat(Person::STILL, 0.5, 1);
            let [.., Some(Attempt { reasons: last, .. })] = room.check.attempts else { panic!("no repetition") };
            let names: Vec<_> = last.names().collect();
            assert_eq!((room.check.counts().repetitions, last.verdict(), &*names.join(", ")), (1, verdict, reasons));
        }
    }

    #[test]
    fn a_person_who_leaves_is_not_judged() {
        let mut room = Room::new();
        (0..10).for_each(|step| room.pass(Some(PERSON.at(0.1 * step as f32))));
        (0..600).for_each(|_| room.pass(None));
        room.repeat(Person::STILL, 0.5, 1);
        assert_eq!(room.check.counts(), Counts { repetitions: 1, cannot_tell: 1, ..Counts::default() });
    }

    #[test]
    fn counts_begin_again_with_the_same_examples() {
        let mut room = Room::new();
        (0..4).for_each(|_| room.repeat(PERSON, 2.0, 1));
        room.repeat(Person::STILL, 0.5, 1);
        let counts = Counts { repetitions: 4, correct: 4, ..Counts::default() };
        assert_eq!(room.check.counts(), counts);
        room.check.restart();
        assert_eq!((room.check.counts(), room.check.examples()), (Counts::default(), 3));
    }
}
