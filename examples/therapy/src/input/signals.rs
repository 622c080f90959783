//! Buttons and touch.

use bica::prelude::*;

use crate::session::{Button, Signal};

/// Buttons and sensors of touch; true while pressed or touched.
#[message]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is pressed or not, in any combination")]
pub struct Pressed {
    /// The button in the chest.
    pub chest: bool,
    /// Bumper of the left foot.
    pub left: bool,
    /// Bumper of the right foot.
    pub right: bool,
    /// Head.
    pub head: bool,
    /// Left hand.
    pub left_hand: bool,
    /// Right hand.
    pub right_hand: bool,
}

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
        const NONE: Pressed =
            Pressed { chest: false, left: false, right: false, head: false, left_hand: false, right_hand: false };
        Self { now: NONE, before: NONE, chest: 0.0 }
    }

    /// Takes what is pressed in this cycle, before it is stepped.
    pub const fn receive(&mut self, pressed: Pressed) {
        (self.before, self.now) = (self.now, pressed);
    }

    fn step(&mut self, time: &Time) {
        self.chest = if self.now.chest { self.chest + time.dt() } else { 0.0 };
    }

    /// Whether it begins in this cycle.
    #[must_use]
    pub const fn begins(&self, signal: Signal) -> bool {
        Self::is(self.now, signal) && !Self::is(self.before, signal)
    }

    const fn is(pressed: Pressed, signal: Signal) -> bool {
        match signal {
            Signal::Press(Button::Chest) => pressed.chest,
            Signal::Press(Button::Left) => pressed.left,
            Signal::Press(Button::Right) => pressed.right,
            Signal::Head => pressed.head,
            Signal::LeftHand => pressed.left_hand,
            Signal::RightHand => pressed.right_hand,
        }
    }

    /// Time since the button in the chest was pressed.
    #[info(unit = "s")]
    #[must_use]
    pub const fn chest_held(&self) -> f32 {
        self.chest
    }
}
