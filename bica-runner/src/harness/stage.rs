//! Environment of a tree under test.

use core::fmt::Debug;

use bica_core::rate::instant_of_cycle;
use bica_core::{Instant, Tree};

use super::History;
use crate::robot::Robot;
use crate::runner::Runner;
use crate::world::World;

/// Environment that provides the time and, for a world, the sensor values.
pub trait Stage<T> {
    /// The instant of the next cycle.
    fn now(&self) -> Instant;

    /// Runs one cycle.
    fn cycle(&mut self, tree: &mut T, history: &mut History);
}

/// Ticks on a regular grid without a world.
#[derive(Clone, Copy, Debug)]
pub struct Ticks {
    hz: f32,
    number: u64,
}

impl Ticks {
    pub(super) const fn new(hz: f32) -> Self {
        Self { hz, number: 0 }
    }
}

impl<T: Tree> Stage<T> for Ticks {
    fn now(&self) -> Instant {
        instant_of_cycle(self.hz, self.number)
    }

    fn cycle(&mut self, tree: &mut T, history: &mut History) {
        tree.tick_with(Stage::<T>::now(self), history);
        self.number += 1;
    }
}

/// Cycles of a runner in a world.
#[derive(Clone, Copy, Debug)]
pub struct InWorld<W>(pub(super) W);

impl<T: Robot<Error: Debug>, W: World<T>> Stage<T> for InWorld<W> {
    fn now(&self) -> Instant {
        self.0.now()
    }

    fn cycle(&mut self, tree: &mut T, history: &mut History) {
        let taken = Runner::new(tree, &mut self.0).with_observer(history).cycle();
        if let Err(error) = taken {
            panic!("the robot rejected the sensor values: {error:?}");
        }
    }
}
