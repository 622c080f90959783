//! The sense of balance.

use bica::prelude::*;
use bica_motion::fall::{FallDetector as Balance, Uprightness};

use crate::input::Measured;

/// Feels a fall, while it happens and after.
#[derive(Debug)]
pub struct FallDetector {
    balance: Balance,
    sound: bool,
}

#[component(budget_us = 2)]
impl FallDetector {
    /// Upright.
    #[must_use]
    pub const fn new() -> Self {
        Self { balance: Balance::new(), sound: true }
    }

    fn step(&mut self, time: &Time, body: &Measured) {
        self.balance.step(body.inertial(), time.dt());
        self.sound = body.fault().is_none();
    }

    /// Whether the robot is upright, falls, or lies, and to which side.
    #[must_use]
    pub const fn state(&self) -> Uprightness {
        self.balance.state()
    }

    /// Whether the robot falls or lies.
    #[must_use]
    pub fn falls(&self) -> bool {
        self.state() != Uprightness::Upright
    }

    /// Whether the robot is on its feet and may go on: it neither falls nor has a [fault](Measured::fault).
    #[must_use]
    pub fn upright(&self) -> bool {
        self.sound && !self.falls()
    }
}
