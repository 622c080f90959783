//! Machines that go to a state by request.

use super::Tree;
use super::cycle_state::VisitOutcome;
use super::layout::{Cycle, Engine, Has, Layout};
use crate::component::Component;
use crate::graph::State;
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::key::Key;
use crate::probe::Probe;
use crate::refusal::{Reason, Refusal};

/// Whether programs for this target can do it: on a microcontroller the code would occupy its memory.
pub(super) const IS_POSSIBLE: bool = cfg!(not(target_os = "none"));

/// Whether `C` is a machine, which can go to a state by request.
#[must_use]
pub const fn goes<T: Has<C>, C: 'static>() -> bool {
    IS_POSSIBLE && !<T::Member as Component>::STATES.is_empty()
}

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Whether the visit of the machine `C` with this outcome, which is open and was not as before, is the run in which it goes to a
    /// state. A machine that begins in this cycle goes nowhere.
    #[inline]
    #[must_use]
    pub fn is_going<C: 'static>(&self, outcome: VisitOutcome) -> bool
    where
        T: Has<C>,
    {
        !outcome.is_started() && self.store.cycle_state().is_going(T::INDEX)
    }

    /// Begins the run in which `C` goes to a state; returns the indices of the state that it leaves, and of the one that it enters.
    pub fn begin_going<C: 'static>(&mut self) -> (usize, usize)
    where
        T: Has<C>,
    {
        let (from, _) = self.store.component_state::<C>().counted_state();
        let to = self.store.cycle_state().takes_going();
        self.begin_run::<C>();
        (from, to)
    }
}

impl<T: Layout> Engine<T> {
    /// Makes an active machine go to a state in the next cycle; returns false if another one does.
    fn go(&self, component: ComponentId, state: usize) -> bool {
        let accepted = self.store.cycle_state().goes(component.index(), state);
        if accepted && let Some(state) = T::component_state(self.store.slots(), component.index()) {
            self.store.leave_steady();
            state.activation().read_period();
        }
        accepted
    }
}

/// Makes a machine go to a state in the next cycle.
pub(super) fn request<T: Tree>(tree: &T, component: ComponentId, state: impl Key) -> Result<(), Refusal> {
    let node = &T::GRAPH.nodes[component.index()];
    let refusal = |name, reason| Refusal { entry: 0, component: node.name, name, reason };
    if !IS_POSSIBLE {
        return Err(refusal("", Reason::Rule("a microcontroller's program goes to no state by request")));
    }
    let found = state.find(node.states.iter().map(|state| state.name)).filter(|state| *state < node.states.len());
    let state = found.ok_or(refusal("", Reason::UnknownState { states: node.states }))?;
    let State { name, initial, .. } = node.states[state];
    let is_active = tree.status(component).is_some_and(|status| status.active && status.held != Hold::Latent);
    let rule = match () {
        () if node.takes(state).is_some() && !initial => {
            "the state takes what a transition has found, so only a transition can enter it"
        }
        () if !is_active => "the machine is latent: it goes to a state while it is active",
        () if !tree.engine().go(component, state) => "another machine goes to a state in this cycle: request it again",
        () => return Ok(()),
    };
    Err(refusal(name, Reason::Rule(rule)))
}
