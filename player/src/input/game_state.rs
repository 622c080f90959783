//! The state of the game.

use bica::prelude::*;

/// Whether the robot is in the game. Each press of the chest button changes it (rules of RoboCup 2009); an operator's `stop` and `play`
/// do the same to one side.
#[derive(Clone, Copy, Debug)]
pub struct GameState {
    pressed: bool,
    playing: bool,
}

#[component(budget_us = 1)]
impl GameState {
    /// Creates the component in the game, with the button released.
    #[must_use]
    pub const fn new() -> Self {
        Self { pressed: false, playing: true }
    }

    /// Takes the state of the chest button: true while pressed.
    pub const fn set_button(&mut self, pressed: bool) {
        self.playing ^= pressed && !self.pressed;
        self.pressed = pressed;
    }

    /// Takes the robot out of the game: it ends its step or kick, and stands until `play` or the next press of the chest button. A
    /// robot that lies stays down.
    #[modulation(stop)]
    pub const fn stop(&mut self) {
        self.playing = false;
    }

    /// Lets the robot play again, as a press of the chest button does.
    #[modulation]
    pub const fn play(&mut self) {
        self.playing = true;
    }

    /// Whether the chest button is pressed.
    #[output]
    #[must_use]
    pub const fn is_button_pressed(&self) -> bool {
        self.pressed
    }

    /// Whether the robot is in the game: neither penalized nor stopped.
    #[output]
    #[must_use]
    pub const fn playing(&self) -> bool {
        self.playing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_press_changes_the_state_once() {
        let mut game = GameState::new();
        for expected in [false, true] {
            for _ in 0..3 {
                game.set_button(true);
                assert_eq!(game.playing(), expected);
            }
            game.set_button(false);
            assert_eq!(game.playing(), expected);
        }
    }

    #[test]
    fn stop_holds_until_play_or_the_next_press() {
        let mut game = GameState::new();
        for release in [GameState::play, |game: &mut GameState| game.set_button(true)] {
            for _ in 0..2 {
                game.stop();
                game.set_button(false);
                assert!(!game.playing());
            }
            release(&mut game);
            assert!(game.playing());
        }
    }
}
