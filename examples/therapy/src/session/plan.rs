//! The steps of a session, and where it is.

use heapless::Vec;

use super::Step;

/// Most steps, most clips of sound, and most nested loops.
pub const MOST_STEPS: usize = 500;
/// Most clips of sound.
pub const MOST_CLIPS: usize = 200;
/// Most loops in one another.
pub const DEEPEST: usize = 4;

/// Where a session is.
#[derive(Clone, Copy, Debug, Default)]
struct Place {
    step: u16,
    counters: [u16; DEEPEST],
}

/// Steps, clips and the present step.
#[derive(Debug)]
pub struct Plan {
    steps: Vec<Step, MOST_STEPS>,
    /// Durations of the clips, s.
    clips: Vec<f32, MOST_CLIPS>,
    loaded: bool,
    place: Place,
    /// Where the steps after the last wait begin.
    begun: Place,
}

impl Default for Plan {
    fn default() -> Self {
        Self::new()
    }
}

impl Plan {
    /// An empty plan.
    #[must_use]
    pub const fn new() -> Self {
        const BEGIN: Place = Place { step: 0, counters: [0; DEEPEST] };
        Self { steps: Vec::new(), clips: Vec::new(), loaded: false, place: BEGIN, begun: BEGIN }
    }

    /// Appends a step; one too many is ignored.
    pub fn add_step(&mut self, step: Step) {
        let _ = self.steps.push(step);
    }

    /// Appends a clip that takes so many seconds; one too many is ignored.
    pub fn add_clip(&mut self, seconds: f32) {
        let _ = self.clips.push(seconds);
    }

    /// All steps and clips are there.
    pub const fn loaded(&mut self) {
        self.loaded = true;
    }

    /// Whether there is a session.
    #[must_use]
    pub const fn is_loaded(&self) -> bool {
        self.loaded
    }

    /// The present step; `None` at the end.
    #[must_use]
    pub fn step(&self) -> Option<Step> {
        self.steps.get(usize::from(self.place.step)).copied()
    }

    /// Number of the present step.
    #[must_use]
    pub const fn at(&self) -> u16 {
        self.place.step
    }

    /// Step with which the present steps began.
    #[must_use]
    pub const fn begun(&self) -> u16 {
        self.begun.step
    }

    /// Whether the last step is done.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.step().is_none()
    }

    /// Duration of a clip, s; 0 if there is no such clip.
    #[must_use]
    pub fn seconds(&self, clip: u16) -> f32 {
        self.clips.get(usize::from(clip)).copied().unwrap_or(0.0)
    }

    /// Goes to the step that follows; of an exercise, that of its result: 0 done, 1 not done, 2 nobody there.
    pub fn pass(&mut self, result: Option<usize>) {
        match (self.step(), result) {
            (Some(Step::Exercise { then, .. }), Some(result)) => self.place.step = then[result],
            _ => self.advance(),
        }
        self.begun = self.place;
    }

    /// Goes to the step that follows a step without a wait.
    pub fn advance(&mut self) {
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
    pub fn go_to(&mut self, step: u16) {
        self.place = Place { step: step.min(self.steps.len() as u16), counters: [0; DEEPEST] };
        self.begun = self.place;
    }

    /// First step after the next wait or exercise, or the end.
    #[must_use]
    pub fn next(&self) -> u16 {
        (self.place.step + 1..self.steps.len() as u16)
            .find(|step| self.begins(*step))
            .unwrap_or(self.steps.len() as u16)
    }

    /// First step after the wait or exercise before the one in which the present steps began, or the begin.
    #[must_use]
    pub fn previous(&self) -> u16 {
        (0..self.begun.step).rev().find(|step| self.begins(*step)).unwrap_or(0)
    }

    /// Whether a step is the first one, or follows a wait or an exercise.
    #[must_use]
    pub fn begins(&self, step: u16) -> bool {
        let before = self.steps.get(usize::from(step).wrapping_sub(1));
        matches!(before, None | Some(Step::Wait(..) | Step::Exercise { .. }))
    }

    /// Goes back to where the steps after the last wait begin.
    pub const fn go_back(&mut self) {
        self.place = self.begun;
    }
}
