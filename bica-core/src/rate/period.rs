//! The time between two runs.

use embassy_time::TICK_HZ;

/// Time between two runs, in clock ticks.
#[derive(Clone, Copy)]
pub(crate) struct Period {
    /// Whole ticks: 0 in every cycle, [`REST`] never.
    whole: u64,
    /// The rest, in units of 2⁻³² ticks.
    fraction: u32,
    /// Runs per second; NaN in every cycle.
    hz: f32,
}

/// Whole ticks of the period of a component that rests.
const REST: u64 = u64::MAX;

/// Whole ticks from which a period is rest, so that sums of two periods do not overflow.
const LONGEST: f64 = (1_u64 << 62) as f64;

impl Period {
    pub(crate) const EVERY_CYCLE: Self = Self { whole: 0, fraction: 0, hz: f32::NAN };

    /// The period of a rate, which is not negative; `None` is every cycle.
    pub(crate) const fn new(hz: Option<f32>) -> Self {
        let Some(hz) = hz else { return Self::EVERY_CYCLE };
        // The quotient is infinite for zero and zero for infinity.
        let ticks = TICK_HZ as f64 / hz as f64;
        if ticks >= LONGEST {
            return Self { whole: REST, fraction: 0, hz };
        }
        let whole = ticks as u64;
        let fraction = (ticks - whole as f64) * (1_u64 << 32) as f64;
        // The quotient has at most 53 bits, so a fraction that rounds up to 1 is cut instead: by less than 2⁻³² ticks.
        Self { whole, fraction: fraction as u32, hz }
    }

    pub(crate) const fn hz(&self) -> Option<f32> {
        if self.hz.is_nan() { None } else { Some(self.hz) }
    }

    /// Whole ticks.
    #[inline]
    pub(crate) const fn whole(&self) -> u64 {
        self.whole
    }

    /// The part below a whole tick, in units of 2⁻³² ticks.
    #[inline]
    pub(crate) const fn fraction(&self) -> u32 {
        self.fraction
    }

    #[inline]
    pub(crate) const fn is_rest(&self) -> bool {
        self.whole == REST
    }

    /// Whether the period is below one clock tick: the component runs in every cycle.
    #[inline]
    pub(crate) const fn is_every_cycle(&self) -> bool {
        self.whole == 0
    }
}
