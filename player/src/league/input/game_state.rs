//! The state of the game.

use bica::prelude::*;

/// Whether the robot is in the game, as the league's server tells each player by its play mode, and no operator has stopped it.
#[derive(Clone, Copy, Debug)]
pub struct GameState {
    admitted: bool,
    stopped: bool,
}

#[component(budget_us = 1)]
impl GameState {
    /// Creates the component in the game.
    #[must_use]
    pub const fn new() -> Self {
        Self { admitted: true, stopped: false }
    }

    /// Takes whether the server lets the robot play.
    pub const fn set(&mut self, admitted: bool) {
        self.admitted = admitted;
    }

    /// Takes the robot out of the game, whatever the server says: it ends its step or kick, and stands until `play`. A robot that lies
    /// stays down.
    #[modulation(stop)]
    pub const fn stop(&mut self) {
        self.stopped = true;
    }

    /// Lets the robot play again when the server does.
    #[modulation]
    pub const fn play(&mut self) {
        self.stopped = false;
    }

    /// Whether the robot is in the game.
    #[output]
    #[must_use]
    pub const fn playing(&self) -> bool {
        self.admitted && !self.stopped
    }
}
