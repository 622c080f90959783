//! Turning on the spot.

use bica::prelude::*;
use bica_motion::walk::Velocity;

use super::Walk;

/// Turns on the spot.
#[derive(Debug)]
pub struct Turn {
    /// Turning speed, rad/s.
    speed: f32,
}

#[component(hz = 50, budget_us = 2)]
impl Turn {
    /// Creates the component with speed zero.
    #[must_use]
    pub const fn new() -> Self {
        Self { speed: 0.0 }
    }

    fn step(&mut self, walk: &mut Walk) {
        walk.request(Velocity { forward: 0.0, left: 0.0, turn: self.speed });
    }

    /// Sets the speed, rad/s, positive to the left.
    pub const fn set_speed(&mut self, speed: f32) {
        self.speed = speed;
    }
}
