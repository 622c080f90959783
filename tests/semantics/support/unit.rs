//! What every test component is made of.

use bica::prelude::*;

use super::event::{Event, Read, Times, note};

/// A value that depends on all that went into it and on the order.
pub(crate) fn mixed(into: u64, more: u64) -> u64 {
    (into ^ more).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(23)
}

/// The bit of the flags that a transition asks for.
pub(crate) fn bit(transition: &str) -> u32 {
    1 << (transition.bytes().map(u32::from).sum::<u32>() % 32)
}

/// State of a test component: its value changes in each run, and depends on what was written to it.
pub(crate) struct Unit {
    name: &'static str,
    /// Its output.
    pub(crate) value: u64,
    /// What was written to it since its last run.
    pub(crate) received: u64,
    /// Which transitions are to be taken.
    pub(crate) flags: u32,
    /// The rate that it is to give its child.
    pub(crate) asks: Option<f32>,
}

impl Unit {
    pub(crate) const fn new(name: &'static str) -> Self {
        Self { name, value: 0, received: 0, flags: 0, asks: None }
    }

    /// What a reader sees.
    pub(crate) fn read(&self) -> Read {
        (self.name, self.value)
    }

    pub(crate) fn started(&mut self) {
        note(Event::Started(self.name));
    }

    pub(crate) fn stopped(&mut self) {
        note(Event::Stopped(self.name));
    }

    /// One run: computes a new value and writes it to others.
    pub(crate) fn body<const R: usize, const W: usize>(
        &mut self,
        state: &'static str,
        time: &Time,
        reads: [Read; R],
        writes: [&mut Self; W],
    ) {
        self.value = mixed(self.value, self.received + 1);
        self.received = 0;
        let time: Times = (time.now.as_ticks(), time.since_run.as_ticks(), time.in_state.as_ticks());
        let writes = self.write(writes);
        note(Event::Body { of: self.name, state, time, reads: reads.into(), writes });
    }

    /// An entry or exit hook: writes to others.
    pub(crate) fn hook<const R: usize, const W: usize>(
        &mut self,
        hook: &'static str,
        reads: [Read; R],
        writes: [&mut Self; W],
    ) {
        let writes = self.write(writes);
        note(Event::Hook { of: self.name, hook, reads: reads.into(), writes });
    }

    /// Whether a transition is to be taken.
    pub(crate) fn asked<const R: usize>(&self, transition: &'static str, reads: [Read; R]) -> bool {
        note(Event::Asked { by: self.name, transition, reads: reads.into() });
        self.flags & bit(transition) != 0
    }

    /// Gives another component the rate that was asked for from outside.
    pub(crate) fn modulate<C: Component>(&mut self, of: &'static str, rate: &mut Rate<C>) {
        if let Some(hz) = self.asks.take() {
            rate.set(hz);
            note(Event::Rated { of, hz: hz.to_bits() });
        }
    }

    fn write<const W: usize>(&self, writes: [&mut Self; W]) -> Vec<&'static str> {
        let write = |other: &mut Self| {
            other.received = mixed(other.received, self.value);
            other.name
        };
        writes.into_iter().map(write).collect()
    }
}

/// A test component: its name, its attributes, its functions. It records its hooks.
macro_rules! unit {
    ($name:ident($($attributes:tt)*) { $($functions:tt)* }) => {
        pub(crate) struct $name {
            pub(crate) unit: crate::support::unit::Unit,
        }

        #[component($($attributes)*)]
        impl $name {
            pub(crate) const fn new() -> Self {
                Self { unit: crate::support::unit::Unit::new(stringify!($name)) }
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
        }
    };
}
pub(crate) use unit;
