//! Buttons and touch.

use bica::prelude::*;

use crate::session::Signal;

/// State of the buttons and touch sensors: chest, left and right bumper, head, left and right hand.
pub type Pressed = [bool; 6];

/// Presses and touches that begin, and how long the chest is pressed.
#[derive(Debug)]
pub struct Signals {
    now: Pressed,
    before: Pressed,
    /// Time for which the chest button has been pressed, s.
    pub(crate) chest: f32,
}

#[component(hz = 100, budget_us = 1)]
impl Signals {
    pub(crate) const fn new() -> Self {
        Self { now: [false; 6], before: [false; 6], chest: 0.0 }
    }

    /// Stores the buttons and sensors that are pressed in this cycle. It must be called before the component runs.
    pub(crate) const fn receive(&mut self, pressed: Pressed) {
        (self.before, self.now) = (self.now, pressed);
    }

    fn step(&mut self, time: &Time) {
        self.chest = if self.now[Signal::Chest as usize] { self.chest + time.dt() } else { 0.0 };
    }

    /// Returns whether a press or touch begins in this cycle.
    pub(crate) const fn begins(&self, signal: Signal) -> bool {
        self.now[signal as usize] && !self.before[signal as usize]
    }
}
