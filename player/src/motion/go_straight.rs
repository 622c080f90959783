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

    fn step(&mut self, walk: &mut Walk) {
        walk.request(Velocity { forward: self.forward, left: 0.0, turn: self.turn });
    }

    /// Sets the speed: `forward` m/s and `turn` rad/s, positive to the left.
    pub const fn set_speed(&mut self, forward: f32, turn: f32) {
        self.forward = forward;
        self.turn = turn;
    }
}
