//! Pause and single cycles of a simulated world.

use std::time::{Duration, Instant};

use bica_wire::message::{WorldChange, WorldState};

/// Maximum step of the clock between two readings: while the loop stands still, no monitor can be heard.
const LONGEST_STEP: Duration = Duration::from_millis(500);

/// Pause state of a simulated world.
#[derive(Debug, Default)]
pub(super) struct Pace {
    paused: bool,
    /// Number of cycles that run although it is paused.
    steps: u32,
    /// Whether the running cycle is the last of these.
    is_last_step: bool,
}

impl Pace {
    /// Applies a change of the world's time.
    pub(super) const fn change(&mut self, change: WorldChange) {
        match change {
            WorldChange::Pause => (self.paused, self.steps) = (true, 0),
            WorldChange::Resume => (self.paused, self.steps) = (false, 0),
            WorldChange::Step { cycles } => (self.paused, self.steps) = (true, self.steps.saturating_add(cycles)),
        }
    }

    /// Returns whether a cycle may run now. In a paused world the cycle uses up a step.
    pub(super) const fn begins_cycle(&mut self) -> bool {
        if !self.paused {
            return true;
        }
        let Some(left) = self.steps.checked_sub(1) else { return false };
        (self.steps, self.is_last_step) = (left, left == 0);
        true
    }

    /// Ends a cycle; returns whether it was the last step.
    pub(super) const fn ends_cycle(&mut self) -> bool {
        std::mem::replace(&mut self.is_last_step, false)
    }

    pub(super) const fn state(&self, cycle: u64) -> WorldState {
        WorldState { paused: self.paused, steps: self.steps, cycle }
    }
}

/// Clock of this computer that stands still while the loop does.
#[derive(Debug)]
pub(super) struct LoopClock {
    time: Duration,
    looked: Instant,
}

impl LoopClock {
    pub(super) fn new() -> Self {
        Self { time: Duration::ZERO, looked: Instant::now() }
    }

    pub(super) fn now(&mut self) -> Duration {
        let now = Instant::now();
        self.time += now.saturating_duration_since(self.looked).min(LONGEST_STEP);
        self.looked = now;
        self.time
    }
}
