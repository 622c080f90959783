//! How often a component runs.
//!
//! # The grid
//!
//! A component with a rate has a grid of instants: the first is its first run after it became active, and the others
//! follow at multiples of the exact period `1 / hz`. Fractions of a clock tick are kept (to 2⁻³² ticks), so the grid does
//! not drift: 30 Hz are 108,000 runs an hour.
//!
//! A tree is ticked about once in a cycle `T = 1 / cycle_hz`, but never exactly. So a grid point has a window:
//!
//! | Rate | A run is due from | A run keeps the grid up to |
//! |---|---|---|
//! | above `cycle_hz / 2` | half a cycle before its grid point | a period and half a cycle after it |
//! | up to `cycle_hz / 2` | a quarter of a cycle before its grid point | a period after it |
//!
//! The declared rate decides which row applies; a component that declares none belongs to the first.
//!
//! # Guarantee
//!
//! **If every tick comes within half a cycle of its nominal instant `n · T`, no run is lost and none is added, at any rate
//! up to `cycle_hz`:** each grid point is served by one run, in order. So in any span a component runs as often as the
//! span has periods, ± 1. If each tick is also within half a cycle of the first one's schedule, a component with
//! `hz = cycle_hz` runs in every tick.
//!
//! A run that comes later than its window starts a new grid: the component runs once, at once, and the grid points in
//! between are dropped. There is never a burst. The grid also starts anew if the clock is set back by more than a period.
//!
//! A period is at least one clock tick, or else the component runs in every cycle. A period above 2⁶² clock ticks is rest.

use core::marker::PhantomData;

use embassy_time::Instant;

use crate::component::Component;

mod grid;
mod period;

pub(crate) use grid::{Grid, Tolerance};
pub(crate) use period::Period;

/// The rate of component `C`: it can be set, at run time, between rest and the declared `hz`.
///
/// A parent takes it as an argument `rate: &mut Rate<C>`; from outside it is
/// [`Tree::rate_mut`](crate::tree::Tree::rate_mut). A rate holds until it is set again, also while `C` is latent.
pub struct Rate<C> {
    period: Period,
    of: PhantomData<fn() -> C>,
}

impl<C: Component> Rate<C> {
    /// Requests `hz` runs per second.
    ///
    /// | `hz` | Rate from now on |
    /// |---|---|
    /// | NaN of either sign | the declared rate |
    /// | negative, −0, 0 | rest: `C` stays active and its children are visited, but only its activation makes it run |
    /// | above the declared rate, also infinite | the declared rate |
    /// | other | `hz` |
    ///
    /// The decision is made on the bits of `hz`, so it is the same on every processor.
    pub fn set(&mut self, hz: f32) {
        self.set_within(hz, C::HZ);
    }

    /// Returns to the declared rate.
    pub fn reset(&mut self) {
        *self = Self::at(C::HZ);
    }
}

impl<C> Rate<C> {
    pub(crate) const fn at(hz: Option<f32>) -> Self {
        Self { period: Period::new(hz), of: PhantomData }
    }

    pub(crate) fn set_within(&mut self, hz: f32, declared: Option<f32>) {
        let hz = limited(hz, declared);
        if self.hz() != hz {
            *self = Self::at(hz);
        }
    }

    /// Returns the requested runs per second; `None` is a run in every cycle.
    #[must_use]
    pub const fn hz(&self) -> Option<f32> {
        self.period.hz()
    }

    pub(crate) const fn period(&self) -> &Period {
        &self.period
    }
}

/// Returns the nominal instant of cycle `number`, from 0, of a tree with `cycle_hz` cycles a second whose clock begins at zero.
#[must_use]
pub fn instant_of_cycle(cycle_hz: f32, number: u64) -> Instant {
    Instant::from_micros((number as f64 * 1e6 / cycle_hz as f64) as u64)
}

/// Returns the rate that a request gives.
///
/// Floating-point comparisons and `max` treat −0 and NaN differently on different processors. The bits of numbers that
/// are not negative are ordered as the numbers are.
const fn limited(hz: f32, declared: Option<f32>) -> Option<f32> {
    const SIGN: u32 = 1 << 31;
    const INFINITY: u32 = f32::INFINITY.to_bits();
    let bits = hz.to_bits();
    if bits & !SIGN > INFINITY {
        return declared;
    }
    if bits & SIGN != 0 {
        return Some(0.0);
    }
    match declared {
        Some(most) if bits > most.to_bits() => declared,
        _ => Some(hz),
    }
}
