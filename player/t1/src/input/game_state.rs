//! The state of the game.

use bica::prelude::*;

/// Whether the robot is in the game, as the league's server tells each player by its play mode.
#[derive(Clone, Copy, Debug)]
pub struct GameState {
    playing: bool,
}

#[component(budget_us = 1)]
impl GameState {
    /// Creates the component in the game.
    #[must_use]
    pub const fn new() -> Self {
        Self { playing: true }
    }

    /// Takes whether the robot may play.
    pub const fn set(&mut self, playing: bool) {
        self.playing = playing;
    }

    /// Whether the robot is in the game.
    #[info]
    #[must_use]
    pub const fn playing(&self) -> bool {
        self.playing
    }
}
