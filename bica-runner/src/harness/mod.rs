//! Test harness: advances a robot in time and checks its states by name.
//!
//! ```
//! # use bica_core::Tree;
//! # use bica_macros::{activation_tree, component};
//! use bica_core::Duration;
//! use bica_runner::harness::Harness;
//!
//! # pub struct Battery { charge: f32 }
//! #
//! # #[component(crate = bica_core)]
//! # impl Battery {
//! #     pub const fn new() -> Self { Self { charge: 1.0 } }
//! # }
//! #
//! # pub struct Vacuum;
//! #
//! # #[component(crate = bica_core)]
//! # impl Vacuum {
//! #     pub const fn new() -> Self { Self }
//! #     #[state(initial)]
//! #     fn clean(&mut self) {}
//! #     #[state]
//! #     fn dock(&mut self) {}
//! #     #[transition(clean -> dock, after_ms = 500)]
//! #     fn is_empty(&self, battery: &Battery) -> bool { battery.charge < 0.2 }
//! #     #[transition(dock -> clean)]
//! #     fn is_full(&self, battery: &Battery) -> bool { battery.charge > 0.9 }
//! # }
//! #
//! # activation_tree! {
//! #     pub struct Robot { root: Vacuum, cycle_hz: 50, components: [Vacuum, Battery], crate: bica_core }
//! # }
//! #
//! let mut test = Harness::new(Robot::new());
//! test.stays::<Vacuum>("clean", Duration::from_secs(2));
//! test.tree_mut().get_mut::<Battery>().charge = 0.1;
//! test.reaches::<Vacuum>("dock", Duration::from_millis(100));
//! ```
//!
//! With the environment variable `BICA_COVERAGE` each harness writes the states that it visited into a file in that folder, which
//! `vicode coverage` reads.

mod history;
mod stage;
mod visits;

use std::boxed::Box;
use std::format;
use std::string::String;

use bica_core::{ComponentId, Duration, Has, Instant, Tree};

pub use history::{History, Transition};
pub use stage::{InWorld, Stage, Ticks};
use visits::Visits;

use crate::robot::Robot;
use crate::world::World;

/// Tree under test, with its environment and the history of its transitions.
#[derive(Debug)]
pub struct Harness<T, S = Ticks> {
    tree: Box<T>,
    stage: S,
    history: History,
    visits: Option<Visits>,
}

impl<T: Tree> Harness<T> {
    /// Creates a harness for a tree that is ticked at its `cycle_hz`. The test writes the input components and reads
    /// the output components.
    #[must_use]
    pub fn new(tree: T) -> Self {
        Self::of_box(Box::new(tree))
    }

    /// Creates a harness like [`new`](Self::new), for a tree that is too large for the stack.
    #[must_use]
    pub fn of_box(tree: Box<T>) -> Self {
        Self {
            tree,
            stage: Ticks::new(T::GRAPH.cycle_hz),
            history: History::new(T::GRAPH),
            visits: Visits::wanted::<T>(),
        }
    }

    /// Replaces the environment by a world that provides the sensor values and the time.
    pub fn in_world<W: World<T>>(self, world: W) -> Harness<T, InWorld<W>>
    where
        T: Robot,
    {
        Harness { tree: self.tree, stage: InWorld(world), history: self.history, visits: self.visits }
    }
}

impl<T: Robot, W: World<T>> Harness<T, InWorld<W>> {
    /// Returns the world.
    pub const fn world(&self) -> &W {
        &self.stage.0
    }

    /// Returns the world for changes.
    pub const fn world_mut(&mut self) -> &mut W {
        &mut self.stage.0
    }
}

impl<T: Tree, S: Stage<T>> Harness<T, S> {
    /// Returns the tree.
    pub const fn tree(&self) -> &T {
        &self.tree
    }

    /// Returns the tree, to write inputs, hold components and set rates.
    pub const fn tree_mut(&mut self) -> &mut T {
        &mut self.tree
    }

    /// Returns the transitions so far.
    pub const fn history(&self) -> &History {
        &self.history
    }

    /// Instant of the next cycle.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.stage.now()
    }

    /// Runs one cycle.
    pub fn cycle(&mut self) {
        let now = self.now();
        self.stage.cycle(&mut self.tree, &mut self.history);
        if let Some(visits) = &mut self.visits {
            visits.note(now, &*self.tree);
        }
    }

    /// Runs `count` cycles.
    pub fn cycles(&mut self, count: usize) {
        (0..count).for_each(|_| self.cycle());
    }

    /// Runs the cycles of a duration.
    pub fn run_for(&mut self, duration: Duration) {
        let end = self.now() + duration;
        while self.now() < end {
            self.cycle();
        }
    }

    /// Runs until `condition` holds, at most for `limit`. Returns the elapsed time.
    ///
    /// # Panics
    /// If the condition does not hold within the limit; the message contains `expectation`.
    #[track_caller]
    pub fn until(&mut self, expectation: &str, limit: Duration, mut condition: impl FnMut(&Self) -> bool) -> Duration {
        let began = self.now();
        while !condition(self) {
            if self.now() >= began + limit {
                self.fail(&format!("{expectation}: not within {} s", seconds(limit)));
            }
            self.cycle();
        }
        self.now() - began
    }

    /// Runs until state machine `C` is active in a state, at most for `limit`. Returns the elapsed time.
    ///
    /// # Panics
    /// If the state is not reached, or `C` has no such state.
    #[track_caller]
    pub fn reaches<C: 'static>(&mut self, state: &str, limit: Duration) -> Duration
    where
        T: Has<C>,
    {
        Self::check_state::<C>(state);
        let expectation = format!("`{}` in state `{state}`", Self::name::<C>());
        self.until(&expectation, limit, |test| test.state::<C>() == Some(state))
    }

    /// Runs for `duration` and checks that state machine `C` stays active in a state.
    ///
    /// # Panics
    /// If it is in another state before or after any cycle, or `C` has no such state.
    #[track_caller]
    pub fn stays<C: 'static>(&mut self, state: &str, duration: Duration)
    where
        T: Has<C>,
    {
        Self::check_state::<C>(state);
        let (began, end) = (self.now(), self.now() + duration);
        while self.now() < end {
            self.cycle();
            if self.state::<C>() != Some(state) {
                let stayed = seconds(self.now() - began);
                self.fail(&format!("`{}` left state `{state}` within {stayed} s", Self::name::<C>()));
            }
        }
    }

    /// Name of the current state of state machine `C`; `None` while it is latent.
    #[must_use]
    pub fn state<C: 'static>(&self) -> Option<&'static str>
    where
        T: Has<C>,
    {
        self.tree.of::<C>().state_name().filter(|_| self.is_active::<C>())
    }

    /// Whether component `C` was active in the last cycle.
    #[must_use]
    pub fn is_active<C: 'static>(&self) -> bool
    where
        T: Has<C>,
    {
        self.tree.of::<C>().is_active()
    }

    fn name<C: 'static>() -> &'static str
    where
        T: Has<C>,
    {
        T::GRAPH.nodes[T::id::<C>().index()].name
    }

    #[track_caller]
    fn check_state<C: 'static>(state: &str)
    where
        T: Has<C>,
    {
        let states = T::GRAPH.nodes[T::id::<C>().index()].states;
        if !states.iter().any(|known| known.name == state) {
            let names = states.iter().map(|state| state.name).collect::<std::vec::Vec<_>>().join(", ");
            panic!("`{}` has no state `{state}`; its states: {names}", Self::name::<C>());
        }
    }

    /// Fails the test with the expectation, the states of all active machines, and the last transitions.
    #[track_caller]
    fn fail(&self, expectation: &str) -> ! {
        let mut active = String::new();
        for id in self.tree.active() {
            active.push_str("\n  ");
            active.push_str(T::GRAPH.nodes[id.index()].name);
            active.push_str(&self.in_state(id));
        }
        panic!(
            "expected: {expectation}\nat {} s, active:{active}\nlast transitions:\n{}",
            seconds(self.now() - Instant::MIN),
            self.history
        );
    }

    fn in_state(&self, id: ComponentId) -> String {
        let Some(status) = self.tree.status(id) else { return String::new() };
        let Some((state, since)) = status.state.zip(status.since) else { return String::new() };
        let name = T::GRAPH.nodes[id.index()].states.get(state).map_or("?", |state| state.name);
        format!(": {name} for {} s", seconds(self.now().saturating_duration_since(since)))
    }
}

fn seconds(duration: Duration) -> f64 {
    duration.as_micros() as f64 / 1e6
}
