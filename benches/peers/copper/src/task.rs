//! The tasks. Copper runs every task in every iteration. A task with a lower rate counts the iterations itself and
//! repeats its last number in between.

use std::sync::atomic::{AtomicU64, Ordering};

use cu29::prelude::*;
use peers::part::mix;

/// Inputs of the sinks in the last application that ran.
static RESULTS: [AtomicU64; 4] = [const { AtomicU64::new(0) }; 4];

pub(crate) fn results<const N: usize>() -> [u64; N] {
    core::array::from_fn(|output| RESULTS[output].load(Ordering::Relaxed))
}

fn put(output: usize, number: u64) {
    RESULTS[output].store(number, Ordering::Relaxed);
}

fn read(message: &CuMsg<u64>) -> u64 {
    message.payload().copied().unwrap_or_default()
}

fn number(config: Option<&ComponentConfig>, key: &str) -> CuResult<u64> {
    let number = config.map(|config| config.get::<u64>(key)).transpose()?.flatten();
    number.ok_or_else(|| format!("the task's configuration has no number `{key}`").into())
}

/// First task of a chain: computes its number from its previous one.
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

/// Middle task of a chain.
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

/// Last task of a chain.
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

/// Period of a task, and its last number.
#[derive(Reflect)]
struct Schedule {
    every: u64,
    wait: u64,
    salt: u64,
    last: u64,
}

impl Schedule {
    fn new(config: Option<&ComponentConfig>) -> CuResult<Self> {
        Ok(Self { every: number(config, "every")?, wait: 0, salt: number(config, "salt")?, last: 1 })
    }

    /// Returns the number for this iteration.
    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64 {
        if self.wait == 0 {
            self.wait = self.every;
            self.last = mix(self.salt, needs(self.last));
        }
        self.wait -= 1;
        self.last
    }
}

/// Task without inputs.
#[derive(Reflect)]
pub struct Source(Schedule);

impl Freezable for Source {}

impl CuSrcTask for Source {
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Schedule::new(config).map(Self)
    }

    fn process(&mut self, _context: &CuContext, output: &mut Self::Output<'_>) -> CuResult<()> {
        output.set_payload(self.0.step(|last| [last]));
        Ok(())
    }
}

/// Generates a task that computes a number from several: `Name: its inputs; their names and indices`.
macro_rules! mix {
    ($name:ident: $inputs:ty; $($need:ident)*) => {
        #[doc = "Task that computes a number from several numbers."]
        #[derive(Reflect)]
        pub struct $name(Schedule);

        impl Freezable for $name {}

        impl CuTask for $name {
            type Input<'m> = $inputs;
            type Output<'m> = output_msg!(u64);
            type Resources<'r> = ();

            fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
                Schedule::new(config).map(Self)
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

/// Task that computes a number from one number.
#[derive(Reflect)]
pub struct Mix1(Schedule);

impl Freezable for Mix1 {}

impl CuTask for Mix1 {
    type Input<'m> = input_msg!(u64);
    type Output<'m> = output_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Schedule::new(config).map(Self)
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

/// Sink with one input.
#[derive(Reflect)]
pub struct Output1 {
    pace: Schedule,
    output: usize,
}

impl Freezable for Output1 {}

impl CuSinkTask for Output1 {
    type Input<'m> = input_msg!(u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self { pace: Schedule::new(config)?, output: number(config, "output")? as usize })
    }

    fn process(&mut self, _context: &CuContext, input: &Self::Input<'_>) -> CuResult<()> {
        put(self.output, self.pace.step(|_| [read(input)]));
        Ok(())
    }
}

/// Sink with two inputs.
#[derive(Reflect)]
pub struct Output2 {
    pace: Schedule,
    output: usize,
}

impl Freezable for Output2 {}

impl CuSinkTask for Output2 {
    type Input<'m> = input_msg!('m, u64, u64);
    type Resources<'r> = ();

    fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
        Ok(Self { pace: Schedule::new(config)?, output: number(config, "output")? as usize })
    }

    fn process(&mut self, _context: &CuContext, (a, b): &Self::Input<'_>) -> CuResult<()> {
        put(self.output, self.pace.step(|_| [read(a), read(b)]));
        Ok(())
    }
}
