//! Buttons and touch.

use bica::prelude::*;

use crate::session::Signal;

/// What is pressed or touched, in the order of [`Signal`].
pub type Pressed = [bool; Signal::COUNT];

/// Presses and touches that begin, and how long the chest is pressed.
#[derive(Debug)]
pub struct Signals {
    now: Pressed,
    before: Pressed,
    chest: f32,
}

#[component(hz = 100, budget_us = 1)]
impl Signals {
    /// Creates the component with nothing pressed.
    #[must_use]
    pub const fn new() -> Self {
        Self { now: [false; Signal::COUNT], before: [false; Signal::COUNT], chest: 0.0 }
    }

    /// Takes what is pressed in this cycle, before it is stepped.
    pub const fn receive(&mut self, pressed: Pressed) {
        (self.before, self.now) = (self.now, pressed);
    }

    fn step(&mut self, time: &Time) {
        self.chest = if self.now[Signal::Chest as usize] { self.chest + time.dt() } else { 0.0 };
    }

    /// Whether it begins in this cycle.
    #[must_use]
    pub const fn begins(&self, signal: Signal) -> bool {
        self.now[signal as usize] && !self.before[signal as usize]
    }

    /// Time since the button in the chest was pressed.
    #[info(unit = "s")]
    #[must_use]
    pub const fn chest_held(&self) -> f32 {
        self.chest
    }
}
