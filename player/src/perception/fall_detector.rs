//! The sense of balance.

use bica::prelude::*;
use bica_motion::fall::{FallDetector as Balance, FallState};

use crate::input::Measured;

/// A fault breaks off what is under way when both feet stand, or after this, s: a kick is over by then.
const PATIENCE: f32 = 3.0;

/// Feels a fall, while it happens and after.
#[derive(Debug)]
pub struct FallDetector {
    balance: Balance,
    /// How much longer a body with a fault may wait for both feet to stand, s.
    patience: f32,
}

#[component(budget_us = 2)]
impl FallDetector {
    /// Upright.
    #[must_use]
    pub const fn new() -> Self {
        Self { balance: Balance::new(), patience: PATIENCE }
    }

    fn step(&mut self, time: &Time, body: &Measured) {
        self.balance.step(body.inertial(), time.dt());
        self.patience = match body.fault() {
            None => PATIENCE,
            Some(_) if body.grounded() => 0.0,
            Some(_) => self.patience - time.dt(),
        };
    }

    /// Whether the robot is upright, falls, or lies, and to which side.
    #[must_use]
    pub const fn state(&self) -> FallState {
        self.balance.state()
    }

    /// Whether the robot falls or lies.
    #[must_use]
    pub fn falls(&self) -> bool {
        self.state() != FallState::Upright
    }

    /// Whether the robot is on its feet and may go on: it neither falls nor has a [fault](Measured::fault) that
    /// waited long enough.
    #[must_use]
    pub fn upright(&self) -> bool {
        self.patience > 0.0 && !self.falls()
    }
}
