//! The sense of balance.

use bica::prelude::*;
use bica_motion::fall::{FallDetector as Balance, Uprightness};

use crate::input::Measured;

/// Feels a fall, while it happens and after.
#[derive(Debug)]
pub struct FallDetector {
    balance: Balance,
}

#[component(budget_us = 2)]
impl FallDetector {
    /// Upright.
    #[must_use]
    pub const fn new() -> Self {
        Self { balance: Balance::new() }
    }

    fn step(&mut self, time: &Time, body: &Measured) {
        self.balance.step(body.inertial(), time.dt());
    }

    /// Whether the robot is upright, falls, or lies, and to which side.
    #[must_use]
    pub const fn state(&self) -> Uprightness {
        self.balance.state()
    }

    /// Whether the robot is on its feet.
    #[must_use]
    pub fn upright(&self) -> bool {
        self.state() == Uprightness::Upright
    }
}
