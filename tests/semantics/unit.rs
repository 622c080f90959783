//! State and functions of every test component.

use bica::prelude::*;

use super::event::{Event, Read, Times, called, record_call};

/// Mixes a number into a value. The result depends on all numbers and their order.
pub(crate) fn mix(into: u64, more: u64) -> u64 {
    (into ^ more).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(23)
}

/// Bit of a transition in the flags.
pub(crate) fn bit(transition: &str) -> u32 {
    1 << (transition.bytes().map(u32::from).sum::<u32>() % 32)
}

/// Number that a hook mixes into the value of its component.
pub(crate) const HOOK: u64 = 77;

/// Name whose bit of the flags begins a job.
pub(crate) const BEGIN: &str = "begin";

/// Result of a job.
pub(crate) fn compute(value: u64) -> u64 {
    mix(value, 5)
}

/// Runs a job.
pub(crate) fn job(value: u64) -> u64 {
    called();
    compute(value)
}

/// What a transition of a test component carries: its name, and the component's value.
pub(crate) type Carried = (&'static str, u64);

/// State of a test component: its value changes in each run, and depends on the values written to it.
pub(crate) struct Unit {
    name: &'static str,
    /// Output of the component.
    pub(crate) value: u64,
    /// Mixture of the values that were written to it since its last run.
    pub(crate) received: u64,
    /// Transitions to take, as bits.
    pub(crate) flags: u32,
    /// Rate that it sets for its child in its next run.
    pub(crate) requested_rate: Option<f32>,
}

impl Unit {
    pub(crate) const fn new(name: &'static str) -> Self {
        Self { name, value: 0, received: 0, flags: 0, requested_rate: None }
    }

    /// Name and value for a reader.
    pub(crate) fn read(&self) -> Read {
        (self.name, self.value)
    }

    pub(crate) fn started(&mut self) {
        record_call(Event::Started(self.name));
    }

    pub(crate) fn stopped(&mut self) {
        record_call(Event::Stopped(self.name));
    }

    /// Runs once: computes a new value and writes it to other components.
    pub(crate) fn body<const R: usize, const W: usize>(
        &mut self,
        state: &'static str,
        time: &Time,
        reads: [Read; R],
        writes: [&mut Self; W],
    ) {
        self.value = mix(self.value, self.received + 1);
        self.received = 0;
        let time: Times = (time.now.as_ticks(), time.since_run.as_ticks(), time.in_state.as_ticks());
        let writes = self.write(writes);
        record_call(Event::Body { of: self.name, state, time, reads: reads.into(), writes });
    }

    /// Runs a hook of a state: changes its value, and writes to other components.
    pub(crate) fn hook<const R: usize, const W: usize>(
        &mut self,
        hook: &'static str,
        reads: [Read; R],
        writes: [&mut Self; W],
    ) {
        self.take(hook, None, reads, writes);
    }

    /// Runs an entry hook that takes the value that a transition found, like [`hook`](Self::hook).
    pub(crate) fn take<const R: usize, const W: usize>(
        &mut self,
        hook: &'static str,
        found: Option<Carried>,
        reads: [Read; R],
        writes: [&mut Self; W],
    ) {
        self.value = mix(self.value, HOOK);
        let writes = self.write(writes);
        record_call(Event::Hook { of: self.name, hook, found, reads: reads.into(), writes });
    }

    /// Evaluates a transition that carries its name and the value of the component.
    pub(crate) fn find<const R: usize>(&self, transition: &'static str, reads: [Read; R]) -> Option<Carried> {
        self.evaluate(transition, reads).then_some((transition, self.value))
    }

    /// Evaluates a transition.
    pub(crate) fn evaluate<const R: usize>(&self, transition: &'static str, reads: [Read; R]) -> bool {
        record_call(Event::Evaluated { by: self.name, transition, reads: reads.into() });
        self.flags & bit(transition) != 0
    }

    /// Takes the result of its job; returns what a new one computes from, if the flags want one.
    pub(crate) fn works(&mut self, result: Option<u64>, is_idle: bool) -> Option<u64> {
        record_call(Event::Worked { of: self.name, result, is_idle });
        self.value = result.map_or(self.value, |result| mix(self.value, result));
        (self.flags & bit(BEGIN) != 0).then_some(self.value)
    }

    /// Sets the rate of another component to the requested one.
    pub(crate) fn modulate<C: Component>(&mut self, of: &'static str, rate: &mut Rate<C>) {
        if let Some(hz) = self.requested_rate.take() {
            rate.set(hz);
            record_call(Event::RateSet { of, hz: hz.to_bits() });
        }
    }

    fn write<const W: usize>(&self, writes: [&mut Self; W]) -> Vec<&'static str> {
        let write = |other: &mut Self| {
            other.received = mix(other.received, self.value);
            other.name
        };
        writes.into_iter().map(write).collect()
    }
}

/// Records the result of a child.
pub(crate) fn ended<C>(of: &'static str, outcome: &Outcome<C>) {
    record_call(Event::Ended { of, end: outcome.end() });
}

/// Records the age of a component.
pub(crate) fn aged<C>(of: &'static str, age: &Age<C>) {
    record_call(Event::Aged { of, since_run: age.since_run().map(|age| age.as_ticks()) });
}

/// Test component with a name, attributes, functions, and conditions of transitions that read nothing. It records its hooks.
macro_rules! unit {
    ($name:ident($($attributes:tt)*)) => {
        unit!($name($($attributes)*) {
            fn step(&mut self, time: &Time) {
                self.unit.body("", time, [], []);
            }
        });
    };
    ($name:ident($($attributes:tt)*) { $($functions:tt)* } $(when { $($condition:ident($($arrow:tt)*);)* })?) => {
        pub(crate) struct $name {
            pub(crate) unit: crate::semantics::unit::Unit,
        }

        #[component($($attributes)*)]
        impl $name {
            pub(crate) const fn new() -> Self {
                Self { unit: crate::semantics::unit::Unit::new(stringify!($name)) }
            }

            #[start]
            fn started(&mut self) {
                self.unit.started();
            }

            #[stop]
            fn stopped(&mut self) {
                self.unit.stopped();
            }

            $($functions)*

            $($(
                #[transition($($arrow)*)]
                fn $condition(&self) -> bool {
                    self.unit.evaluate(stringify!($condition), [])
                }
            )*)?
        }
    };
}
pub(crate) use unit;
