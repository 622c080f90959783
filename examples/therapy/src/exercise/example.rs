//! Learns what is correct from repetitions of the same person.

use bica_motion::side::Side;
use glam::Vec3;
use heapless::Vec;

use super::{Counter, Posture, Reference, Repetition};

/// Number of correct repetitions from which the check learns.
pub const EXAMPLES: usize = 3;
/// Repetitions that are kept while it learns; some may be only a swing of the arm.
const KEPT: usize = 6;
/// Share of the largest range that a repetition must have; a swing of the arm has less.
const WHOLE: f32 = 0.6;
/// Time at the beginning in which the arms rest, s.
const REST: f32 = 0.1;
/// Noise that is added to that of an arm, degrees, when the arms are compared.
const USUAL_NOISE: f32 = 5.0;

/// Correct repetitions of one person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Example {
    /// The arm that moves.
    pub arm: Side,
    /// Its rest, and the plane of the movement.
    pub reference: Reference,
    /// Least peak of the repetitions, degrees.
    pub peak: f32,
    /// Largest lean of the trunk, degrees.
    pub lean: f32,
    /// Mean duration, s.
    pub seconds: f32,
}

/// Learns an [`Example`] from the first repetitions of a person.
#[derive(Clone, Debug)]
pub struct Learner {
    arms: [Arm; 2],
}

/// What is learnt of an arm.
#[derive(Clone, Debug)]
struct Arm {
    rest: Vec3,
    /// Time that is left until the rest of the arm is known, s.
    resting: f32,
    counter: Option<Counter>,
    repetitions: Vec<Repetition, KEPT>,
    last: [Option<Vec3>; 2],
    /// Sum of the squared differences from the mean of both neighbours, and their number.
    jitter: (f32, u32),
}

impl Default for Learner {
    fn default() -> Self {
        Self::new()
    }
}

impl Learner {
    /// Begins with both arms at rest.
    #[must_use]
    pub const fn new() -> Self {
        Self { arms: [Arm::NEW, Arm::NEW] }
    }

    /// Takes a posture, `None` if the trunk is not seen, `dt` seconds after the previous one.
    pub fn push(&mut self, posture: Option<&Posture>, dt: f32) {
        for (index, arm) in self.arms.iter_mut().enumerate() {
            arm.push(posture.and_then(|posture| Some((posture.trunk, posture.arms[index]?))), dt);
        }
    }

    /// Ends a stream, as at the end of a recording.
    pub fn finish(&mut self) {
        for arm in &mut self.arms {
            let ended = arm.counter.as_mut().and_then(Counter::finish);
            arm.keep(ended);
            arm.last = [None; 2];
        }
    }

    /// Number of repetitions so far, 0 to [`EXAMPLES`].
    #[must_use]
    pub fn repetitions(&self) -> usize {
        self.arms.iter().map(|arm| arm.whole().count()).max().unwrap_or(0).min(EXAMPLES)
    }

    /// What was learnt; `None` if an arm has not done so many repetitions, at most [`EXAMPLES`].
    #[must_use]
    pub fn example(&self, repetitions: usize) -> Option<Example> {
        let [left, right] = &self.arms;
        let both = [(Side::Left, left), (Side::Right, right)];
        let able = both.into_iter().filter(|(_, arm)| arm.whole().count() >= repetitions.max(1));
        able.max_by(|a, b| a.1.score().total_cmp(&b.1.score())).and_then(|(side, arm)| arm.example(side))
    }
}

impl Arm {
    const NEW: Self = Self {
        rest: Vec3::ZERO,
        resting: REST,
        counter: None,
        repetitions: Vec::new(),
        last: [None; 2],
        jitter: (0.0, 0),
    };

    fn push(&mut self, seen: Option<(Vec3, Vec3)>, dt: f32) {
        let Some((trunk, arm)) = seen else {
            self.last = [None; 2];
            return self.counter.iter_mut().for_each(|counter| counter.miss(dt));
        };
        if let [Some(first), Some(second)] = self.last {
            self.jitter.0 += (second - 0.5 * (first + arm)).length_squared();
            self.jitter.1 += 1;
        }
        self.last = [self.last[1], Some(arm)];
        if self.resting > 0.0 {
            self.rest += arm;
            self.resting -= dt;
        } else {
            let rest = self.rest.normalize_or(arm);
            let counter = self.counter.get_or_insert_with(|| Counter::new(Reference { rest, normal: None }));
            let ended = counter.push(trunk, arm, dt);
            self.keep(ended);
        }
    }

    fn keep(&mut self, ended: Option<Repetition>) {
        let Some(ended) = ended else { return };
        if self.repetitions.is_full() {
            self.repetitions.remove(0);
        }
        let _ = self.repetitions.push(ended);
    }

    fn whole(&self) -> impl Iterator<Item = &Repetition> {
        let largest = self.repetitions.iter().map(|repetition| repetition.range).fold(0.0, f32::max);
        self.repetitions.iter().filter(move |repetition| repetition.range >= WHOLE * largest)
    }

    /// Larger for the arm that moves more and is seen better: a hidden arm seems to jump.
    fn score(&self) -> f32 {
        let largest = self.repetitions.iter().map(|repetition| repetition.range).fold(0.0, f32::max);
        let jitter = libm::sqrtf(self.jitter.0 / self.jitter.1.max(1) as f32).to_degrees();
        largest / (USUAL_NOISE + jitter)
    }

    fn example(&self, arm: Side) -> Option<Example> {
        let rest = self.counter.as_ref()?.reference().rest;
        let normal = self.whole().map(|repetition| repetition.normal).sum::<Vec3>().try_normalize()?;
        let fold =
            |value: fn(&Repetition) -> f32, start, of: fn(f32, f32) -> f32| self.whole().map(value).fold(start, of);
        Some(Example {
            arm,
            reference: Reference { rest, normal: Some(normal) },
            peak: fold(|repetition| repetition.peak, f32::INFINITY, f32::min),
            lean: fold(|repetition| repetition.lean, 0.0, f32::max),
            seconds: fold(|repetition| repetition.seconds, 0.0, |a, b| a + b) / self.whole().count() as f32,
        })
    }
}
