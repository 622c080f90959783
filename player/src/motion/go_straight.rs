//! Forward walking.

use bica::prelude::*;
use bica_motion::walk::Velocity;

use super::Walk;

/// Goes straight on, with a little steering.
#[derive(Debug)]
pub struct GoStraight {
    forward: f32,
    turn: f32,
}

#[component(hz = 50, budget_us = 2)]
impl GoStraight {
    /// Does not go yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { forward: 0.0, turn: 0.0 }
    }

    fn step(&mut self, walk: &mut Walk) {
        walk.request(Velocity { forward: self.forward, left: 0.0, turn: self.turn });
    }

    /// Goes at `forward` m/s, steering at `turn` rad/s.
    pub const fn go(&mut self, forward: f32, turn: f32) {
        self.forward = forward;
        self.turn = turn;
    }
}
