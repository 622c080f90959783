//! The tasks. Copper runs every task in every iteration. A task with a lower rate counts the iterations itself and
//! repeats its last number in between.

use std::sync::atomic::{AtomicU64, Ordering};

use cu29::prelude::*;

use crate::part::mix;

/// Inputs of the sinks in the last application that ran.
static RESULTS: [AtomicU64; 4] = [const { AtomicU64::new(0) }; 4];

pub(crate) fn results<const N: usize>() -> [u64; N] {
    core::array::from_fn(|output| RESULTS[output].load(Ordering::Relaxed))
}

fn read(message: &CuMsg<u64>) -> u64 {
    message.payload().copied().unwrap_or_default()
}

fn number(config: Option<&ComponentConfig>, key: &str) -> CuResult<u64> {
    let number = config.map(|config| config.get::<u64>(key)).transpose()?.flatten();
    number.ok_or_else(|| format!("the task's configuration has no number `{key}`").into())
}

/// What a task keeps between two iterations.
trait State: Sized {
    fn new(config: Option<&ComponentConfig>) -> CuResult<Self>;

    /// Returns the number for this iteration; `needs` gets the last one.
    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64;
}

/// First task of a chain: its last number.
#[derive(Reflect)]
struct Last(u64);

impl State for Last {
    fn new(_config: Option<&ComponentConfig>) -> CuResult<Self> {
        Ok(Self(1))
    }

    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64 {
        self.0 = mix(0, needs(self.0));
        self.0
    }
}

/// Other tasks of a chain.
#[derive(Reflect)]
struct Nothing;

impl State for Nothing {
    fn new(_config: Option<&ComponentConfig>) -> CuResult<Self> {
        Ok(Self)
    }

    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64 {
        mix(0, needs(0))
    }
}

/// Tasks with a period, in iterations.
#[derive(Reflect)]
struct Schedule {
    every: u64,
    wait: u64,
    salt: u64,
    last: u64,
}

impl State for Schedule {
    fn new(config: Option<&ComponentConfig>) -> CuResult<Self> {
        Ok(Self { every: number(config, "every")?, wait: 0, salt: number(config, "salt")?, last: 1 })
    }

    fn step<const N: usize>(&mut self, needs: impl FnOnce(u64) -> [u64; N]) -> u64 {
        if self.wait == 0 {
            self.wait = self.every;
            self.last = mix(self.salt, needs(self.last));
        }
        self.wait -= 1;
        self.last
    }
}

/// Generates a task of a trait: `Trait Name: its state; its inputs; their pattern and names`.
macro_rules! task {
    (CuSrcTask $name:ident: $state:ident) => {
        task!(@ $name: $state,, CuSrcTask {
            type Output<'m> = output_msg!(u64);

            fn process(&mut self, _: &CuContext, output: &mut Self::Output<'_>) -> CuResult<()> {
                output.set_payload(self.state.step(|last| [last]));
                Ok(())
            }
        });
    };
    (CuTask $name:ident: $state:ident; $inputs:ty; $pattern:pat => $($need:ident)*) => {
        task!(@ $name: $state,, CuTask {
            type Input<'m> = $inputs;
            type Output<'m> = output_msg!(u64);

            fn process(&mut self, _: &CuContext, $pattern: &Self::Input<'_>, output: &mut Self::Output<'_>) -> CuResult<()> {
                output.set_payload(self.state.step(|_| [$(read($need)),*]));
                Ok(())
            }
        });
    };
    (CuSinkTask $name:ident: $state:ident; $inputs:ty; $pattern:pat => $($need:ident)*) => {
        task!(@ $name: $state, output, CuSinkTask {
            type Input<'m> = $inputs;

            fn process(&mut self, _: &CuContext, $pattern: &Self::Input<'_>) -> CuResult<()> {
                RESULTS[self.output].store(self.state.step(|_| [$(read($need)),*]), Ordering::Relaxed);
                Ok(())
            }
        });
    };
    (@ $name:ident: $state:ident, $($output:ident)?, $trait:ident { $($item:item)* }) => {
        #[doc = "A task."]
        #[derive(Reflect)]
        pub struct $name {
            state: $state,
            $($output: usize,)?
        }

        impl Freezable for $name {}

        impl $trait for $name {
            type Resources<'r> = ();

            fn new(config: Option<&ComponentConfig>, _resources: Self::Resources<'_>) -> CuResult<Self> {
                Ok(Self { state: State::new(config)?, $($output: number(config, stringify!($output))? as usize)? })
            }

            $($item)*
        }
    };
}

task!(CuSrcTask Start: Last);
task!(CuTask Link: Nothing; input_msg!(u64); a => a);
task!(CuSinkTask End: Nothing; input_msg!(u64); a => a);
task!(CuSrcTask Source: Schedule);
task!(CuTask Mix1: Schedule; input_msg!(u64); a => a);
task!(CuTask Mix2: Schedule; input_msg!('m, u64, u64); (a, b) => a b);
task!(CuTask Mix3: Schedule; input_msg!('m, u64, u64, u64); (a, b, c) => a b c);
task!(CuTask Mix6: Schedule; input_msg!('m, u64, u64, u64, u64, u64, u64); (a, b, c, d, e, f) => a b c d e f);
task!(CuSinkTask Output1: Schedule; input_msg!(u64); a => a);
task!(CuSinkTask Output2: Schedule; input_msg!('m, u64, u64); (a, b) => a b);
