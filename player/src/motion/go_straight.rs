//! Walking forward.

use bica::prelude::*;
use bica_motion::walk::Velocity;

use super::Walk;

/// Walks forward and steers.
#[derive(Debug)]
pub struct GoStraight {
    /// Forward speed, m/s.
    forward: f32,
    /// Turning speed, rad/s.
    turn: f32,
}

#[component(hz = 50, budget_us = 2)]
impl GoStraight {
    /// Creates the component with speed zero.
    #[must_use]
    pub const fn new() -> Self {
        Self { forward: 0.0, turn: 0.0 }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, walk: &mut Walk) {
        walk.request(Velocity { forward: self.forward, left: 0.0, turn: self.turn });
    }

    /// Sets the speed: `forward` m/s and `turn` rad/s, positive to the left. The speed holds until it is set again or the
    /// component becomes latent.
    #[modulation]
    pub const fn set_speed(
        &mut self,
        /// Forward speed; negative is backward.
        #[range(-0.3..=0.4)]
        #[unit("m/s")]
        #[step(0.01)]
        forward: f32,
        /// Turning speed, positive to the left.
        #[range(-1.5..=1.5)]
        #[unit("rad/s")]
        #[step(0.05)]
        turn: f32,
    ) {
        self.forward = forward;
        self.turn = turn;
    }

    /// Requested forward speed.
    #[output(unit = "m/s")]
    #[must_use]
    pub const fn forward(&self) -> f32 {
        self.forward
    }

    /// Requested turning speed, positive to the left.
    #[output(unit = "rad/s")]
    #[must_use]
    pub const fn turn(&self) -> f32 {
        self.turn
    }
}
