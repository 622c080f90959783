//! The workloads: graphs of parts, each of which computes a number from the numbers of its inputs.
//!
//! A part without inputs uses its own previous number. All numbers begin at 1. Each part comes after its inputs in the
//! list.

use std::sync::atomic::{AtomicU32, Ordering};

/// Part of a workload; one component in each design.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Name.
    pub name: &'static str,
    /// Period in cycles; the part runs in the first cycle.
    pub every: u64,
    /// Initial value of the mixture, different for each part.
    pub salt: u64,
    /// Inputs, by their index in the graph; at most [`MAX_INPUTS`].
    pub needs: &'static [usize],
}

/// Maximum number of inputs of a part.
pub const MAX_INPUTS: usize = 6;

/// Diamond from sensor to motor: two parts in the middle have the same input.
pub const DIAMOND: [Part; 4] = [
    Part { name: "bottom", every: 1, salt: 0, needs: &[] },
    Part { name: "left", every: 1, salt: 1, needs: &[0] },
    Part { name: "right", every: 1, salt: 2, needs: &[0] },
    Part { name: "top", every: 1, salt: 3, needs: &[1, 2] },
];

/// Graph like the tree of a soccer forward, at rates of 100, 50, 20, 10 and 5 Hz.
pub const FORWARD: [Part; 25] = [
    Part { name: "camera", every: 5, salt: 0, needs: &[] },
    Part { name: "joints", every: 1, salt: 1, needs: &[] },
    Part { name: "inertial", every: 1, salt: 2, needs: &[] },
    Part { name: "feet", every: 1, salt: 3, needs: &[] },
    Part { name: "game", every: 20, salt: 4, needs: &[] },
    Part { name: "kinematics", every: 1, salt: 5, needs: &[1, 2] },
    Part { name: "segments", every: 5, salt: 6, needs: &[0] },
    Part { name: "ball", every: 5, salt: 7, needs: &[6, 5] },
    Part { name: "net", every: 5, salt: 8, needs: &[6, 5] },
    Part { name: "lines", every: 10, salt: 9, needs: &[6, 5] },
    Part { name: "field_boundary", every: 10, salt: 10, needs: &[6] },
    Part { name: "odometry", every: 1, salt: 11, needs: &[5, 3] },
    Part { name: "ball_memory", every: 2, salt: 12, needs: &[7, 11] },
    Part { name: "net_memory", every: 5, salt: 13, needs: &[8, 11] },
    Part { name: "localization", every: 10, salt: 14, needs: &[9, 11] },
    Part { name: "fall", every: 2, salt: 15, needs: &[2, 3] },
    Part { name: "player", every: 10, salt: 16, needs: &[12, 13, 14, 10, 15, 4] },
    Part { name: "search", every: 5, salt: 17, needs: &[16, 12] },
    Part { name: "gaze", every: 2, salt: 18, needs: &[17, 12] },
    Part { name: "head", every: 1, salt: 19, needs: &[18, 1] },
    Part { name: "approach", every: 5, salt: 20, needs: &[16, 12, 13] },
    Part { name: "walk", every: 1, salt: 21, needs: &[20, 11] },
    Part { name: "legs", every: 1, salt: 22, needs: &[21, 2] },
    Part { name: "arms", every: 1, salt: 23, needs: &[21] },
    Part { name: "lights", every: 20, salt: 24, needs: &[16] },
];

/// Output parts of [`FORWARD`]: head, legs, arms, lights.
pub const OUTPUTS: [usize; 4] = [19, 22, 23, 24];

const NAMES: [&str; 100] = {
    const DIGITS: &str = "00010203040506070809101112131415161718192021222324252627282930313233343536373839\
        40414243444546474849505152535455565758596061626364656667686970717273747576777879\
        8081828384858687888990919293949596979899";
    let mut names = [""; 100];
    let mut at = 0;
    while at < 100 {
        names[at] = DIGITS.split_at(2 * at).1.split_at(2).0;
        at += 1;
    }
    names
};

const BEFORE: [usize; 100] = {
    let mut before = [0; 100];
    let mut at = 1;
    while at < 100 {
        before[at] = at - 1;
        at += 1;
    }
    before
};

/// Chain of `N` ≤ 100 parts, each of which has the previous one as its input.
#[must_use]
pub fn chain<const N: usize>() -> [Part; N] {
    core::array::from_fn(|at| Part {
        name: NAMES[at],
        every: 1,
        salt: 0,
        needs: if at == 0 { &[] } else { core::slice::from_ref(&BEFORE[at]) },
    })
}

/// Number of rounds of work in each step.
static ROUNDS: AtomicU32 = AtomicU32::new(0);

/// Sets the size of all steps: 24 rounds take about 20 ns, 0 rounds nothing.
pub fn set_rounds(rounds: u32) {
    ROUNDS.store(rounds, Ordering::Relaxed);
}

/// The work of a step beyond its own computation. The compiler knows neither its size nor its result.
#[inline]
#[must_use]
pub fn work(number: u64) -> u64 {
    match ROUNDS.load(Ordering::Relaxed) {
        0 => number,
        rounds => rounds_of_work(number, rounds),
    }
}

#[inline(never)]
fn rounds_of_work(number: u64, rounds: u32) -> u64 {
    (0..rounds).fold(number, |number, _| number.wrapping_mul(31).rotate_left(7))
}

/// Computes the number of a part from its inputs.
#[inline]
#[must_use]
pub fn mix<const N: usize>(salt: u64, needs: [u64; N]) -> u64 {
    work(combine(salt, needs))
}

/// Mixes numbers without the work of a step.
#[inline]
#[must_use]
pub fn combine<const N: usize>(salt: u64, needs: [u64; N]) -> u64 {
    needs.into_iter().fold(salt, |sum, need| sum.wrapping_add(need).wrapping_mul(31).wrapping_add(1))
}

/// Result of a graph: the number of the last part, or a mixture of several outputs.
#[must_use]
pub fn result(numbers: &[u64]) -> u64 {
    if numbers.len() == FORWARD.len() {
        combine(0, OUTPUTS.map(|output| numbers[output]))
    } else {
        numbers.last().copied().unwrap_or_default()
    }
}
