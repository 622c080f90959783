//! Learning of correct repetitions from examples of the same person.

use bica_motion::side::Side;
use glam::Vec3;
use heapless::Vec;

use super::{Counter, Posture, Reference, Repetition, Seen};

/// Number of correct repetitions from which the check learns.
pub(crate) const EXAMPLES: usize = 3;
/// Number of repetitions kept while the check learns; some may be only a swing of the arm.
const KEPT: usize = 6;
/// Least range of a whole repetition, as a fraction of the largest range; a swing of the arm has less.
const WHOLE: f32 = 0.6;
/// Time at the beginning in which the direction of the resting arms is measured, s.
const REST: f32 = 0.1;
/// Noise added to the measured noise of an arm when the arms are compared, degrees.
const USUAL_NOISE: f32 = 5.0;

/// Correct repetitions of one person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Example {
    /// The arm that moves.
    pub(crate) arm: Side,
    /// Direction of the resting arm, and plane of the movement.
    pub(crate) reference: Reference,
    /// Least peak of the repetitions, degrees.
    pub(crate) peak: f32,
    /// Largest lean of the trunk, degrees.
    pub(crate) lean: f32,
    /// Mean duration, s.
    pub(crate) seconds: f32,
}

/// Learns an [`Example`] from the first repetitions of a person.
#[derive(Clone, Debug)]
pub(crate) struct Learner {
    arms: [Arm; 2],
}

/// Data learnt for one arm.
#[derive(Clone, Debug)]
struct Arm {
    rest: Vec3,
    /// Remaining time until the direction of the resting arm is known, s.
    resting: f32,
    counter: Option<Counter>,
    repetitions: Vec<Repetition, KEPT>,
    last: [Option<Vec3>; 2],
    /// Sum of the squared differences between a direction and the mean of both its neighbours, and their number.
    jitter: (f32, u32),
}

impl Learner {
    /// A learner that begins with both arms at rest.
    pub(crate) const fn new() -> Self {
        Self { arms: [Arm::NEW, Arm::NEW] }
    }

    /// Processes a posture, `dt` seconds after the previous one; `None` if the trunk is not seen.
    pub(crate) fn push(&mut self, posture: Option<&Posture>, dt: f32) {
        for (arm, side) in self.arms.iter_mut().zip(Side::BOTH) {
            arm.push(posture.and_then(|posture| posture.side(side)), dt);
        }
    }

    /// Ends a stream, for example at the end of a recording.
    pub(crate) fn finish(&mut self) {
        for arm in &mut self.arms {
            let ended = arm.counter.as_mut().and_then(Counter::finish);
            arm.keep(ended);
            arm.last = [None; 2];
        }
    }

    /// Number of repetitions so far, 0 to [`EXAMPLES`].
    pub(crate) fn repetitions(&self) -> usize {
        self.arms.iter().map(|arm| arm.whole().count()).max().unwrap_or(0).min(EXAMPLES)
    }

    /// Returns the learnt example; `None` if no arm has done `repetitions` repetitions, at most [`EXAMPLES`].
    pub(crate) fn example(&self, repetitions: usize) -> Option<Example> {
        let able = self.arms.iter().zip(Side::BOTH).filter(|(arm, _)| arm.whole().count() >= repetitions.max(1));
        able.max_by(|a, b| a.0.score().total_cmp(&b.0.score())).and_then(|(arm, side)| arm.example(side))
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

    fn push(&mut self, seen: Option<Seen>, dt: f32) {
        let ended = self.counter.as_mut().and_then(|counter| counter.push(seen, dt));
        self.keep(ended);
        let Some(Seen { arm, .. }) = seen else {
            self.last = [None; 2];
            return;
        };
        if let [Some(first), Some(second)] = self.last {
            self.jitter.0 += (second - 0.5 * (first + arm)).length_squared();
            self.jitter.1 += 1;
        }
        self.last = [self.last[1], Some(arm)];
        if self.resting > 0.0 {
            self.rest += arm;
            self.resting -= dt;
        } else if self.counter.is_none() {
            let mut counter = Counter::new(Reference { rest: self.rest.normalize_or(arm), normal: None });
            counter.push(seen, dt);
            self.counter = Some(counter);
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

    /// Score of an arm: larger if it moves more and is seen better. A hidden arm seems to jump.
    fn score(&self) -> f32 {
        let largest = self.repetitions.iter().map(|repetition| repetition.range).fold(0.0, f32::max);
        let jitter = libm::sqrtf(self.jitter.0 / self.jitter.1.max(1) as f32).to_degrees();
        largest / (USUAL_NOISE + jitter)
    }

    fn example(&self, arm: Side) -> Option<Example> {
        let rest = self.counter.as_ref()?.reference.rest;
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
