//! A state machine without code.

use embassy_time::{Duration, Instant};

use super::component_state::{ComponentState, Policy};
use super::cycle_state::CycleState;
use super::results::taken_after;
use crate::graph::Transition;
use crate::rate::{Period, Tolerance};

/// The machine of a component that is always active: its rate, its timers and the order of its transitions, by the code that runs trees,
/// without functions of states, hooks and children. Tools try a machine with it.
pub struct LoneMachine {
    cycle: CycleState,
    state: ComponentState,
    period: Period,
    policy: Policy,
}

impl LoneMachine {
    /// Creates the machine of a component that declares `hz` in a tree of `cycle_hz` cycles a second. It starts in the state `initial`.
    #[must_use]
    pub const fn new(cycle_hz: f32, hz: Option<f32>, initial: usize) -> Self {
        Self {
            cycle: CycleState::new(false),
            state: ComponentState::new(),
            period: Period::new(hz),
            policy: Policy::new(Some(initial), false, Tolerance::new(cycle_hz, hz)),
        }
    }

    /// Runs one cycle. If the machine is due, it takes the first of `transitions` that leaves its state, whose timer has expired and that
    /// `holds`, which gets its index. Returns the index of the transition, or none, of a run; `None` of a cycle without one.
    pub fn tick(
        &mut self,
        now: Instant,
        transitions: &[Transition],
        mut holds: impl FnMut(usize) -> bool,
    ) -> Option<Option<usize>> {
        self.cycle.begin(now, false);
        if !self.cycle.visit(&self.state, &self.period, &self.policy).is_due() {
            return None;
        }
        let (from, taken_before) = self.state.counted_state();
        let is_taken = |(index, one): &(usize, &Transition)| {
            one.from == from
                && one.after_ms.is_none_or(|ms| self.state.has_been_in_state(ms, now))
                && one.times.is_none_or(|times| taken_before < times)
                && holds(*index)
        };
        let taken = transitions.iter().enumerate().find(is_taken);
        if let Some((index, transition)) = taken {
            self.state.enter(transition.to, now);
            self.state.count(taken_after(transitions, index, taken_before));
        }
        Some(taken.map(|(index, _)| index))
    }

    /// Index of the state.
    #[must_use]
    pub fn state(&self) -> usize {
        self.state.state().unwrap_or_else(|| self.policy.initial())
    }

    /// Number of transitions with [`times`](Transition::times) that it took in a row.
    #[must_use]
    pub fn taken(&self) -> u8 {
        self.state.state().map_or(0, |_| self.state.counted_state().1)
    }

    /// Time in the state.
    #[must_use]
    pub fn in_state(&self, now: Instant) -> Duration {
        self.state.in_state(now)
    }
}
