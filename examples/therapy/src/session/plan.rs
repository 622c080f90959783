//! The steps of a session, and where it is.

use heapless::Vec;

use super::Step;
use crate::robot::Order;

/// Most steps.
pub(crate) const MOST_STEPS: usize = 500;
/// Most clips of sound.
pub(crate) const MOST_CLIPS: usize = 200;
/// Most loops in one another.
pub(crate) const DEEPEST: usize = 4;

/// Where a session is.
#[derive(Clone, Copy, Debug)]
struct Place {
    step: u16,
    counters: [u16; DEEPEST],
}

/// Steps, clips and the present step.
#[derive(Debug)]
pub(crate) struct Plan {
    steps: Vec<Step, MOST_STEPS>,
    /// Durations of the clips, s.
    clips: Vec<f32, MOST_CLIPS>,
    /// Whether all steps and clips are there.
    pub(crate) loaded: bool,
    place: Place,
    /// Where the steps after the last wait begin.
    begun: Place,
}

/// Whether a step is the first one, or follows a wait or an exercise.
pub(crate) fn begins(steps: &[Step], step: usize) -> bool {
    matches!(steps.get(step.wrapping_sub(1)), None | Some(Step::Wait(..) | Step::Exercise { .. }))
}

impl Plan {
    pub(crate) const fn new() -> Self {
        const BEGIN: Place = Place { step: 0, counters: [0; DEEPEST] };
        Self { steps: Vec::new(), clips: Vec::new(), loaded: false, place: BEGIN, begun: BEGIN }
    }

    /// Takes a part of a session; a step or clip too many is ignored.
    pub(crate) fn load(&mut self, order: Order) {
        match order {
            Order::Step(step) => _ = self.steps.push(step),
            Order::Clip(seconds) => _ = self.clips.push(seconds),
            Order::Loaded => self.loaded = true,
        }
    }

    /// The present step; `None` at the end.
    pub(crate) fn step(&self) -> Option<Step> {
        self.steps.get(usize::from(self.place.step)).copied()
    }

    /// Number of the present step.
    pub(crate) const fn at(&self) -> u16 {
        self.place.step
    }

    /// Step with which the present steps began.
    pub(crate) const fn begun(&self) -> u16 {
        self.begun.step
    }

    /// Duration of a clip, s; 0 if there is no such clip.
    pub(crate) fn seconds(&self, clip: u16) -> f32 {
        self.clips.get(usize::from(clip)).copied().unwrap_or(0.0)
    }

    /// Goes to the step that follows; of an exercise, that of its result: 0 done, 1 not done, 2 nobody there.
    pub(crate) fn pass(&mut self, result: Option<usize>) {
        match (self.step(), result) {
            (Some(Step::Exercise { then, .. }), Some(result)) => self.place.step = then[result],
            _ => self.advance(),
        }
        self.begun = self.place;
    }

    /// Goes to the step that follows a step without a wait.
    pub(crate) fn advance(&mut self) {
        match self.step() {
            None => {}
            Some(Step::GoTo(to)) => self.place.step = to,
            Some(Step::Again { from, times, counter }) => {
                let count = &mut self.place.counters[usize::from(counter) % DEEPEST];
                *count += 1;
                let again = *count < times;
                *count = if again { *count } else { 0 };
                self.place.step = if again { from } else { self.place.step + 1 };
            }
            Some(_) => self.place.step += 1,
        }
    }

    /// Goes to a step, at most to the end, as if it followed a wait. Loops begin anew.
    pub(crate) fn go_to(&mut self, step: u16) {
        self.place = Place { step: step.min(self.steps.len() as u16), counters: [0; DEEPEST] };
        self.begun = self.place;
    }

    /// First step after the next wait or exercise, or the end.
    pub(crate) fn next(&self) -> u16 {
        let end = self.steps.len() as u16;
        (self.place.step + 1..end).find(|step| begins(&self.steps, (*step).into())).unwrap_or(end)
    }

    /// First step after the wait or exercise before the one in which the present steps began, or the begin.
    pub(crate) fn previous(&self) -> u16 {
        (0..self.begun.step).rev().find(|step| begins(&self.steps, (*step).into())).unwrap_or(0)
    }

    /// Goes back to where the steps after the last wait begin.
    pub(crate) const fn go_back(&mut self) {
        self.place = self.begun;
    }
}
