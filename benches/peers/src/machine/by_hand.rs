//! The machine as a `match`.

use super::{B_US, D_US, input, work};
use crate::subject::Subject;
use crate::timer::Timer;

#[derive(Clone, Copy)]
enum State {
    A,
    B,
    C,
    D,
    E,
}

/// The machine as a `match`.
pub struct ByHand<T> {
    state: State,
    entered: u64,
    number: u64,
    timer: T,
}

impl<T: Timer> ByHand<T> {
    /// Creates the machine, with `timer` around each step.
    pub const fn new(timer: T) -> Self {
        Self { state: State::A, entered: 0, number: 1, timer }
    }
}

impl<T: Timer> Subject for ByHand<T> {
    fn cycle(&mut self, now: u64) {
        let (state, entered, number) = (&mut self.state, &mut self.entered, &mut self.number);
        self.timer.time(0, || {
            let input = input(now);
            let next = match *state {
                State::A if input.is_multiple_of(7) => Some(State::B),
                State::B if now - *entered >= B_US => Some(State::C),
                State::C if input.is_multiple_of(5) => Some(State::D),
                State::D if now - *entered >= D_US => Some(State::E),
                State::E if input.is_multiple_of(3) => Some(State::A),
                _ => None,
            };
            if let Some(next) = next {
                *state = next;
                *entered = now;
            }
            *number = match *state {
                State::A => work::<0>(*number),
                State::B => work::<1>(*number),
                State::C => work::<2>(*number),
                State::D => work::<3>(*number),
                State::E => work::<4>(*number),
            };
        });
    }

    fn result(&self) -> u64 {
        self.number
    }
}
