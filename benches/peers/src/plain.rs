//! Functions written by hand, one for each component, called in sequence. The cost of a framework is the difference to
//! them.
//!
//! They are measured twice (`INLINED`): as functions that are not inlined, like those of components with more work, and
//! inlined, which lets the compiler fold a chain into few multiplications, as it does with the steps of BICA.

use crate::part::{self, mix};
use crate::subject::{CYCLE_US, Subject};
use crate::timer::Timer;

#[inline]
fn step<const INLINED: bool, const N: usize>(numbers: &mut [u64], to: usize, salt: u64, needs: [usize; N]) {
    if INLINED { inlined(numbers, to, salt, needs) } else { called(numbers, to, salt, needs) }
}

#[inline(never)]
fn called<const N: usize>(numbers: &mut [u64], to: usize, salt: u64, needs: [usize; N]) {
    inlined(numbers, to, salt, needs);
}

#[expect(clippy::inline_always, reason = "it is what is measured")]
#[inline(always)]
fn inlined<const N: usize>(numbers: &mut [u64], to: usize, salt: u64, needs: [usize; N]) {
    numbers[to] = mix(salt, needs.map(|need| numbers[need]));
}

/// Chain of `N`.
pub struct Chain<T, const N: usize, const INLINED: bool> {
    numbers: [u64; N],
    timer: T,
}

impl<T: Timer, const N: usize, const INLINED: bool> Chain<T, N, INLINED> {
    /// Creates the chain, with `timer` around each component.
    pub const fn new(timer: T) -> Self {
        Self { numbers: [1; N], timer }
    }
}

impl<T: Timer, const N: usize, const INLINED: bool> Subject for Chain<T, N, INLINED> {
    fn cycle(&mut self, _now: u64) {
        self.timer.time(0, || step::<INLINED, _>(&mut self.numbers, 0, 0, [0]));
        for at in 1..N {
            self.timer.time(at, || step::<INLINED, _>(&mut self.numbers, at, 0, [at - 1]));
        }
    }

    fn result(&self) -> u64 {
        part::result(&self.numbers)
    }
}

/// The diamond.
pub struct Diamond<T, const INLINED: bool> {
    numbers: [u64; 4],
    timer: T,
}

impl<T: Timer, const INLINED: bool> Diamond<T, INLINED> {
    /// Creates the diamond, with `timer` around each component.
    pub const fn new(timer: T) -> Self {
        Self { numbers: [1; 4], timer }
    }
}

impl<T: Timer, const INLINED: bool> Subject for Diamond<T, INLINED> {
    fn cycle(&mut self, _now: u64) {
        let numbers = &mut self.numbers;
        self.timer.time(0, || step::<INLINED, _>(numbers, 0, 0, [0]));
        self.timer.time(1, || step::<INLINED, _>(numbers, 1, 1, [0]));
        self.timer.time(2, || step::<INLINED, _>(numbers, 2, 2, [0]));
        self.timer.time(3, || step::<INLINED, _>(numbers, 3, 3, [1, 2]));
    }

    fn result(&self) -> u64 {
        part::result(&self.numbers)
    }
}

/// The tree of the forward.
pub struct Forward<T, const INLINED: bool> {
    numbers: [u64; 25],
    timer: T,
}

impl<T: Timer, const INLINED: bool> Forward<T, INLINED> {
    /// Creates the graph, with `timer` around each component.
    pub const fn new(timer: T) -> Self {
        Self { numbers: [1; 25], timer }
    }
}

/// Steps of a cycle: `numbers, timer, cycle: index every [needs]; …`.
macro_rules! steps {
    ($numbers:ident, $timer:expr, $cycle:ident: $($to:literal $every:literal [$($need:literal),*];)*) => {
        $(if $every == 1 || $cycle.is_multiple_of($every) {
            $timer.time($to, || step::<INLINED, _>($numbers, $to, $to, [$($need),*]));
        })*
    };
}

impl<T: Timer, const INLINED: bool> Subject for Forward<T, INLINED> {
    fn cycle(&mut self, now: u64) {
        let (numbers, cycle) = (&mut self.numbers, now / CYCLE_US);
        steps! { numbers, self.timer, cycle:
            0 5 [0]; 1 1 [1]; 2 1 [2]; 3 1 [3]; 4 20 [4];
            5 1 [1, 2]; 6 5 [0]; 7 5 [6, 5]; 8 5 [6, 5]; 9 10 [6, 5];
            10 10 [6]; 11 1 [5, 3]; 12 2 [7, 11]; 13 5 [8, 11]; 14 10 [9, 11];
            15 2 [2, 3]; 16 10 [12, 13, 14, 10, 15, 4]; 17 5 [16, 12]; 18 2 [17, 12]; 19 1 [18, 1];
            20 5 [16, 12, 13]; 21 1 [20, 11]; 22 1 [21, 2]; 23 1 [21]; 24 20 [16];
        }
    }

    fn result(&self) -> u64 {
        part::result(&self.numbers)
    }
}
