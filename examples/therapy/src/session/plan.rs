//! Steps of a session, and the current position.

use heapless::Vec;

use super::Step;
use crate::robot::Order;

/// Maximum number of steps.
pub(crate) const MOST_STEPS: usize = 500;
/// Maximum number of clips of sound.
pub(crate) const MOST_CLIPS: usize = 200;
/// Maximum depth of nested loops.
pub(crate) const DEEPEST: usize = 4;

/// Position in a session.
#[derive(Clone, Copy, Debug)]
struct Place {
    step: u16,
    counters: [u16; DEEPEST],
}

/// Steps, clips and the current position.
#[derive(Debug)]
pub(crate) struct Plan {
    steps: Vec<Step, MOST_STEPS>,
    /// Durations of the clips, s.
    clips: Vec<f32, MOST_CLIPS>,
    /// Whether all steps and clips have been loaded.
    pub(crate) loaded: bool,
    place: Place,
    /// Position of the first step after the last wait or exercise.
    begun: Place,
}

/// Returns whether a step is the first one, or follows a wait or an exercise.
pub(crate) fn begins(steps: &[Step], step: usize) -> bool {
    matches!(steps.get(step.wrapping_sub(1)), None | Some(Step::Wait(..) | Step::Exercise { .. }))
}

impl Plan {
    pub(crate) const fn new() -> Self {
        const BEGIN: Place = Place { step: 0, counters: [0; DEEPEST] };
        Self { steps: Vec::new(), clips: Vec::new(), loaded: false, place: BEGIN, begun: BEGIN }
    }

    /// Loads a part of a session. A step or clip beyond the maximum is ignored.
    pub(crate) fn load(&mut self, order: Order) {
        match order {
            Order::Step(step) => _ = self.steps.push(step),
            Order::Clip(seconds) => _ = self.clips.push(seconds),
            Order::Loaded => self.loaded = true,
        }
    }

    /// The current step; `None` at the end.
    pub(crate) fn step(&self) -> Option<Step> {
        self.steps.get(usize::from(self.place.step)).copied()
    }

    /// Index of the current step.
    pub(crate) const fn at(&self) -> u16 {
        self.place.step
    }

    /// Index of the first step after the last wait or exercise.
    pub(crate) const fn begun(&self) -> u16 {
        self.begun.step
    }

    /// Duration of a clip, s; 0 if there is no such clip.
    pub(crate) fn seconds(&self, clip: u16) -> f32 {
        self.clips.get(usize::from(clip)).copied().unwrap_or(0.0)
    }

    /// Leaves a wait or an exercise. After an exercise the step depends on its result: 0 done, 1 not done, 2 nobody there.
    pub(crate) fn pass(&mut self, result: Option<usize>) {
        match (self.step(), result) {
            (Some(Step::Exercise { then, .. }), Some(result)) => self.place.step = then[result],
            _ => self.advance(),
        }
        self.begun = self.place;
    }

    /// Goes to the step after a step without a wait.
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

    /// Jumps to a step, at most to the end, as after a wait. Loops begin anew.
    pub(crate) fn go_to(&mut self, step: u16) {
        self.place = Place { step: step.min(self.steps.len() as u16), counters: [0; DEEPEST] };
        self.begun = self.place;
    }

    /// Returns the first step after the next wait or exercise, or the end.
    pub(crate) fn next(&self) -> u16 {
        let end = self.steps.len() as u16;
        (self.place.step + 1..end).find(|step| begins(&self.steps, (*step).into())).unwrap_or(end)
    }

    /// Returns the first step of the part before the current one (parts are separated by waits and exercises), or 0.
    pub(crate) fn previous(&self) -> u16 {
        (0..self.begun.step).rev().find(|step| begins(&self.steps, (*step).into())).unwrap_or(0)
    }

    /// Goes back to the first step after the last wait or exercise.
    pub(crate) const fn go_back(&mut self) {
        self.place = self.begun;
    }
}
