//! The tasks. Copper runs every task in every iteration; one that has a lower rate counts iterations itself and says its
//! last number again.

use std::sync::atomic::{AtomicU64, Ordering};

use cu29::prelude::*;
use peers::part::mix;

/// What the sinks of the last application that ran were given.
static RESULTS: [AtomicU64; 4] = [const { AtomicU64::new(0) }; 4];

pub(crate) fn results<const N: usize>() -> [u64; N] {
    core::array::from_fn(|place| RESULTS[place].load(Ordering::Relaxed))
}

fn put(place: usize, number: u64) {
    RESULTS[place].store(number, Ordering::Relaxed);
}

fn read(message: &CuMsg<u64>) -> u64 {
    message.payload().copied().unwrap_or_default()
}

fn number(config: Option<&ComponentConfig>, key: &str) -> CuResult<u64> {
    let number = config.map(|config| config.get::<u64>(key)).transpose()?.flatten();
    number.ok_or_else(|| format!("the task's configuration has no number `{key}`").into())
}

/// The first of a chain: goes on from its own number.
#[derive(Reflect)]
pub struct Start {
    number: u64,
}

impl Freezable for Start {}

impl CuSrcTask for Start {
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(_config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self { number: 1 })
    }

    fn process(&mut self, _context: &CuContext, output: &mut Self::Output<'_>) -> CuResult<()> {
        self.number = mix(0, [self.number]);
        output.set_payload(self.number);
        Ok(())
    }
}

/// One of a chain.
#[derive(Reflect)]
pub struct Link;

impl Freezable for Link {}

impl CuTask for Link {
    type Input<'m> = input_msg!(u64);
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(_config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self)
    }

    fn process(
        &mut self,
        _context: &CuContext,
        input: &Self::Input<'_>,
        output: &mut Self::Output<'_>,
    ) -> CuResult<()> {
        output.set_payload(mix(0, [read(input)]));
        Ok(())
    }
}

/// The last of a chain.
#[derive(Reflect)]
pub struct End;

impl Freezable for End {}

impl CuSinkTask for End {
    type Input<'m> = input_msg!(u64);
    type Resources<'r> = ();

    fn new(_config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self)
    }

    fn process(&mut self, _context: &CuContext, input: &Self::Input<'_>) -> CuResult<()> {
        put(0, mix(0, [read(input)]));
        Ok(())
    }
}

/// When a task is due, and what it said last.
#[derive(Reflect)]
struct Pace {
    every: u64,
    wait: u64,
    salt: u64,
    last: u64,
}

impl Pace {
    fn new(config: Option<&ComponentConfig>) -> CuResult<Self> {
        Ok(Self { every: number(config, "every")?, wait: 0, salt: number(config, "salt")?, last: 1 })
    }

    /// Its number in this iteration.
    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64 {
        if self.wait == 0 {
            self.wait = self.every;
            self.last = mix(self.salt, needs(self.last));
        }
        self.wait -= 1;
        self.last
    }
}

/// A task that needs nothing.
#[derive(Reflect)]
pub struct Source(Pace);

impl Freezable for Source {}

impl CuSrcTask for Source {
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Pace::new(config).map(Self)
    }

    fn process(&mut self, _context: &CuContext, output: &mut Self::Output<'_>) -> CuResult<()> {
        output.set_payload(self.0.step(|last| [last]));
        Ok(())
    }
}

/// A task that makes one number of several: `Name: its inputs; their names and places`.
macro_rules! mix {
    ($name:ident: $inputs:ty; $($need:ident)*) => {
        #[doc = "A task that makes one number of several."]
        #[derive(Reflect)]
        pub struct $name(Pace);

        impl Freezable for $name {}

        impl CuTask for $name {
            type Input<'m> = $inputs;
            type Output<'m> = output_msg!(u64);
            type Resources<'r> = ();

            fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
                Pace::new(config).map(Self)
            }

            fn process(&mut self, _: &CuContext, input: &Self::Input<'_>, output: &mut Self::Output<'_>) -> CuResult<()> {
                let ($($need,)*) = input;
                output.set_payload(self.0.step(|_| [$(read($need)),*]));
                Ok(())
            }
        }
    };
}

mix!(Mix2: input_msg!('m, u64, u64); a b);
mix!(Mix3: input_msg!('m, u64, u64, u64); a b c);
mix!(Mix6: input_msg!('m, u64, u64, u64, u64, u64, u64); a b c d e f);

/// A task that makes one number of another.
#[derive(Reflect)]
pub struct Mix1(Pace);

impl Freezable for Mix1 {}

impl CuTask for Mix1 {
    type Input<'m> = input_msg!(u64);
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Pace::new(config).map(Self)
    }

    fn process(
        &mut self,
        _context: &CuContext,
        input: &Self::Input<'_>,
        output: &mut Self::Output<'_>,
    ) -> CuResult<()> {
        output.set_payload(self.0.step(|_| [read(input)]));
        Ok(())
    }
}

/// A sink that needs one number.
#[derive(Reflect)]
pub struct Output1 {
    pace: Pace,
    place: usize,
}

impl Freezable for Output1 {}

impl CuSinkTask for Output1 {
    type Input<'m> = input_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self { pace: Pace::new(config)?, place: number(config, "place")? as usize })
    }

    fn process(&mut self, _context: &CuContext, input: &Self::Input<'_>) -> CuResult<()> {
        put(self.place, self.pace.step(|_| [read(input)]));
        Ok(())
    }
}

/// A sink that needs two numbers.
#[derive(Reflect)]
pub struct Output2 {
    pace: Pace,
    place: usize,
}

impl Freezable for Output2 {}

impl CuSinkTask for Output2 {
    type Input<'m> = input_msg!('m, u64, u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self { pace: Pace::new(config)?, place: number(config, "place")? as usize })
    }

    fn process(&mut self, _context: &CuContext, (a, b): &Self::Input<'_>) -> CuResult<()> {
        put(self.place, self.pace.step(|_| [read(a), read(b)]));
        Ok(())
    }
}
