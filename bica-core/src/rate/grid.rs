//! The grid of instants at which a component runs.

use core::cell::Cell;

use embassy_time::TICK_HZ;

use super::Period;

/// How far from its grid point a run may be, in clock ticks.
#[derive(Clone, Copy)]
pub(crate) struct Tolerance {
    /// Time before the grid point from which a run is due.
    early: u64,
    /// Time that the window is longer than two periods.
    slack: u64,
}

impl Tolerance {
    /// The tolerance of a component that declares `hz` in a tree that is ticked `cycle_hz` times per second.
    pub(crate) const fn new(cycle_hz: f32, hz: Option<f32>) -> Self {
        let cycle = TICK_HZ as f64 / cycle_hz as f64;
        let is_fast = match hz {
            Some(hz) => hz as f64 * 2.0 > cycle_hz as f64,
            None => true,
        };
        let early = (cycle * if is_fast { 0.5 } else { 0.25 }) as u64;
        Self { early, slack: if is_fast { 2 * early } else { early } }
    }
}

/// The last grid point of a component.
///
/// Differences between instants are taken modulo 2⁶⁴ ticks, so a clock may wrap around.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Grid<'a> {
    /// The last grid point minus the time that a run may be early, in clock ticks.
    pub(crate) origin: &'a Cell<u64>,
    /// Fraction of the grid point, in units of 2⁻³² ticks.
    pub(crate) fraction: &'a Cell<u32>,
}

impl Grid<'_> {
    /// Starts a grid at `now`.
    #[inline]
    pub(crate) fn start(self, now: u64, tolerance: Tolerance) {
        self.origin.set(now.wrapping_sub(tolerance.early));
        self.fraction.set(0);
    }

    /// Returns whether a run is due, and if so moves the grid on.
    #[inline]
    pub(crate) fn is_due(self, now: u64, period: &Period, tolerance: Tolerance) -> bool {
        let elapsed = now.wrapping_sub(self.origin.get());
        if elapsed < period.whole() {
            return false;
        }
        // A rest is above here only if the elapsed time is the largest number, which is below no limit. The limit of any
        // other period does not wrap around.
        if elapsed < period.whole().wrapping_mul(2).wrapping_add(tolerance.slack) {
            let (fraction, carry) = self.fraction.get().overflowing_add(period.fraction());
            self.fraction.set(fraction);
            self.origin.set(self.origin.get().wrapping_add(period.whole()).wrapping_add(u64::from(carry)));
            return true;
        }
        self.is_due_outside(now, period, tolerance)
    }

    /// Returns whether a run is due at an instant before or after the window, and if so starts a new grid there.
    #[cold]
    #[inline(never)]
    fn is_due_outside(self, now: u64, period: &Period, tolerance: Tolerance) -> bool {
        if period.is_every_cycle() {
            return true;
        }
        let point = self.origin.get().wrapping_add(tolerance.early);
        let since = now.wrapping_sub(point).cast_signed();
        let is_anew = !period.is_rest() && (since >= 0 || since.unsigned_abs() > period.whole());
        if is_anew {
            self.start(now, tolerance);
        }
        is_anew
    }
}
