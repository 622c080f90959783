//! Control of a game between two cycles.

use bica_app::interrupt;

/// Next step of a game's loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NextStep {
    /// One cycle.
    Cycle,
    /// The game is paused over its link; without a link a cycle.
    Pause,
    /// The game ends.
    End,
}

/// Control of a game between two cycles: whether it continues.
///
/// `()` plays until the rules end the game or the user interrupts the program.
pub trait GameControl {
    /// Decides the next step. It may block: the clock of a game in real time stands still meanwhile. `is_over` is
    /// whether the rules end the game here.
    fn next(&mut self, is_over: bool) -> NextStep;

    /// Returns a line for the recording's log, after each cycle.
    fn note(&mut self) -> Option<String> {
        None
    }

    /// Whether an operator may pause the game over its link.
    fn lets_operators_pause(&self) -> bool {
        true
    }

    /// Called once if the recording ends before the game.
    fn recording_ended(&mut self, _reason: &str) {}
}

impl GameControl for () {
    fn next(&mut self, is_over: bool) -> NextStep {
        if is_over || interrupt::requested() { NextStep::End } else { NextStep::Cycle }
    }

    fn recording_ended(&mut self, reason: &str) {
        eprintln!("warning: the recording ended, the game goes on: {reason}");
    }
}
