//! State machine with five states, state code, conditions and timers, and the same machine as a `match`.

use bica::prelude::*;

/// Five states in a ring; two of them are left by a timer.
pub struct Ring {
    /// Value that the transitions read.
    pub input: u32,
    work: u64,
}

#[component]
impl Ring {
    const fn new() -> Self {
        Self { input: 0, work: 1 }
    }

    #[state(initial)]
    fn a(&mut self) {
        self.work = self.work.wrapping_mul(31).wrapping_add(1);
    }

    #[state]
    fn b(&mut self) {
        self.work = self.work.wrapping_mul(37).wrapping_add(2);
    }

    #[state]
    fn c(&mut self) {
        self.work = self.work.wrapping_mul(41).wrapping_add(3);
    }

    #[state]
    fn d(&mut self) {
        self.work = self.work.wrapping_mul(43).wrapping_add(4);
    }

    #[state]
    fn e(&mut self) {
        self.work = self.work.wrapping_mul(47).wrapping_add(5);
    }

    #[transition(a -> b)]
    fn go_b(&self) -> bool {
        self.input.is_multiple_of(7)
    }

    #[transition(b -> c, after_ms = 5)]
    fn go_c(&self) -> bool {
        true
    }

    #[transition(c -> d)]
    fn go_d(&self) -> bool {
        self.input.is_multiple_of(5)
    }

    #[transition(d -> e, after_ms = 3)]
    fn go_e(&self) -> bool {
        true
    }

    #[transition(e -> a)]
    fn go_a(&self) -> bool {
        self.input.is_multiple_of(3)
    }
}

activation_tree! {
    /// Tree with one state machine.
    pub struct Machine {
        root: Ring,
        cycle_hz: 1000,
        components: [Ring],
    }
}

#[derive(Clone, Copy)]
enum State {
    A,
    B,
    C,
    D,
    E,
}

/// The same machine as a `match`.
pub struct ByHand {
    state: State,
    entered: u64,
    /// Value that the transitions read.
    pub input: u32,
    work: u64,
}

impl ByHand {
    /// Machine in its first state.
    #[must_use]
    #[expect(clippy::new_without_default, reason = "components have a `new` without a `Default` too")]
    pub const fn new() -> Self {
        Self { state: State::A, entered: 0, input: 0, work: 1 }
    }

    /// Runs one step at `now`, µs.
    #[inline(never)]
    pub fn step(&mut self, now: u64) {
        let next = match self.state {
            State::A if self.input.is_multiple_of(7) => Some(State::B),
            State::B if now - self.entered >= 5000 => Some(State::C),
            State::C if self.input.is_multiple_of(5) => Some(State::D),
            State::D if now - self.entered >= 3000 => Some(State::E),
            State::E if self.input.is_multiple_of(3) => Some(State::A),
            _ => None,
        };
        if let Some(next) = next {
            self.state = next;
            self.entered = now;
        }
        let (factor, term) = match self.state {
            State::A => (31, 1),
            State::B => (37, 2),
            State::C => (41, 3),
            State::D => (43, 4),
            State::E => (47, 5),
        };
        self.work = self.work.wrapping_mul(factor).wrapping_add(term);
    }
}
