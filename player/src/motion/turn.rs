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

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, walk: &mut Walk) {
        walk.request(Velocity { forward: 0.0, left: 0.0, turn: self.speed });
    }

    /// Sets the speed, rad/s, positive to the left. It holds until it is set again or the component becomes latent.
    #[modulation]
    pub const fn set_speed(
        &mut self,
        /// Turning speed, positive to the left.
        #[range(-1.5..=1.5)]
        #[unit("rad/s")]
        #[step(0.05)]
        speed: f32,
    ) {
        self.speed = speed;
    }

    /// Requested turning speed, positive to the left.
    #[output(unit = "rad/s")]
    #[must_use]
    pub const fn speed(&self) -> f32 {
        self.speed
    }
}
