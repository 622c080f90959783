//! Requests of a person, and the end of tasks.

use super::Session;
use crate::body::{Mover, Sound, Walk};
use crate::exercise::ExerciseCheck;
use crate::session::{Signal, Step, Task, Until};

/// Time without a skeleton after which the person counts as absent, s.
const NOBODY: f32 = 15.0;

/// Request of a person.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// Jumps to a step.
    GoTo(u16),
    Start,
    Pause,
    GoOn,
    Stop,
}

impl Session {
    /// Stores a request for the next run. No request replaces a stop.
    pub(super) const fn ask(&mut self, wish: Wish) {
        if !matches!(self.wish, Some(Wish::Stop)) {
            self.wish = Some(wish);
        }
    }

    pub(super) fn hear(&mut self) {
        self.heard = self.wish.take();
        if let Some(Wish::GoTo(step)) = self.heard {
            self.plan.go_to(step);
        }
    }

    /// The signal that the current step waits for.
    pub(super) fn awaited(&self) -> Option<Signal> {
        match self.plan.step() {
            Some(Step::Wait(Until::Signal(signal), _)) => Some(signal),
            _ => None,
        }
    }

    /// Result of the exercise; `None` until it has ended: 0 done, 1 not done, 2 nobody there.
    pub(super) fn result(&self, check: &ExerciseCheck) -> Option<usize> {
        let Some(Step::Exercise { repetitions, limit, .. }) = self.plan.step() else { return None };
        let wanted = (f32::from(repetitions) * self.ease) as u16;
        if check.counts().repetitions >= wanted.max(1) {
            Some(0)
        } else if self.unseen.0 > NOBODY {
            Some(2)
        } else {
            (self.waited >= limit).then_some(1)
        }
    }
}

/// Ends a task.
pub(super) fn end(task: Task, mover: &mut Mover, walk: &mut Walk, sound: &mut Sound) {
    sound.stop(task);
    if task.has(Task::Movement) {
        mover.freeze();
    }
    if task.has(Task::Walk) {
        walk.halt();
    }
}
