//! Buttons and touch.

use bica::prelude::*;

use crate::session::Signal;

/// What is pressed or touched: chest, left and right bumper, head, left and right hand.
pub type Pressed = [bool; 6];

/// Presses and touches that begin, and how long the chest is pressed.
#[derive(Debug)]
pub struct Signals {
    now: Pressed,
    before: Pressed,
    /// Time since the button in the chest was pressed, s.
    pub(crate) chest: f32,
}

#[component(hz = 100, budget_us = 1)]
impl Signals {
    pub(crate) const fn new() -> Self {
        Self { now: [false; 6], before: [false; 6], chest: 0.0 }
    }

    /// Takes what is pressed in this cycle, before it is stepped.
    pub(crate) const fn receive(&mut self, pressed: Pressed) {
        (self.before, self.now) = (self.now, pressed);
    }

    fn step(&mut self, time: &Time) {
        self.chest = if self.now[Signal::Chest as usize] { self.chest + time.dt() } else { 0.0 };
    }

    /// Whether it begins in this cycle.
    pub(crate) const fn begins(&self, signal: Signal) -> bool {
        self.now[signal as usize] && !self.before[signal as usize]
    }
}
