//! How often a component runs, and how that is changed while it does.

use core::marker::PhantomData;

use embassy_time::TICK_HZ;

use crate::component::Component;

/// The rate of component `C`, modulable between rest and its declared `hz`.
///
/// A parent asks for it with an argument `rate: &mut Rate<C>`; from outside it is
/// [`Tree::rate_mut`](crate::tree::Tree::rate_mut). What was set holds until it is set again, also while `C` is latent.
pub struct Rate<C> {
    hz: Option<f32>,
    period: u64,
    of: PhantomData<fn() -> C>,
}

impl<C: Component> Rate<C> {
    /// Asks for `hz` runs per second.
    ///
    /// More than the declared rate gives the declared rate. Zero or less gives rest: `C` stays active and its children
    /// are visited, but apart from the run that every activation brings it does not run. NaN gives the declared rate.
    pub fn set(&mut self, hz: f32) {
        self.set_within(hz, C::HZ);
    }

    /// Goes back to the declared rate.
    pub fn reset(&mut self) {
        *self = Self::at(C::HZ);
    }
}

impl<C> Rate<C> {
    pub(crate) const fn at(hz: Option<f32>) -> Self {
        Self { hz, period: period(hz), of: PhantomData }
    }

    pub(crate) fn set_within(&mut self, hz: f32, declared: Option<f32>) {
        if self.hz != Some(hz) {
            let too_fast = declared.is_some_and(|most| hz > most);
            *self = Self::at(if hz.is_nan() || too_fast { declared } else { Some(hz.max(0.0)) });
        }
    }

    /// Runs per second that are asked for now; `None` is a run in every cycle.
    #[must_use]
    pub const fn hz(&self) -> Option<f32> {
        self.hz
    }

    /// Ticks of the clock between two runs: 0 runs in every cycle, [`REST`] never.
    pub(crate) const fn period(&self) -> &u64 {
        &self.period
    }
}

/// The period of a component that rests.
pub(crate) const REST: u64 = u64::MAX;

/// The whole ticks of one period. Rounded down: a component that is as fast as its tree misses no cycle.
const fn period(hz: Option<f32>) -> u64 {
    match hz {
        None => 0,
        // Beyond the range of u64 the conversion saturates, and one divided by zero is infinite.
        Some(hz) => (TICK_HZ as f64 / hz as f64) as u64,
    }
}
