//! Results of machines: a child that has ended, begins anew, and is tried again.

use super::cycle_state::VisitOutcome;
use super::layout::{Cycle, Has, Layout, Machine, MemberOf, Visit};
use super::member::policy;
use crate::component::Component;
use crate::graph::{End, State, Transition};
use crate::outcome::Outcome;
use crate::probe::Probe;
use crate::text::Text;

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Whether the child `C` is active and has ended with this result.
    #[inline]
    #[must_use]
    pub fn has_ended<C: 'static>(&self, end: End) -> bool
    where
        T: Has<C>,
    {
        self.outcome::<C>().end() == Some(end)
    }

    /// The result of the child `C`.
    #[inline]
    #[must_use]
    pub fn outcome<C: 'static>(&self) -> Outcome<C>
    where
        T: Has<C>,
    {
        let state = self.store.component_state::<C>();
        if state.activation().is_any_latent() || state.begins_anew() {
            return Outcome::new(None);
        }
        let states = <T::Member as Component>::STATES;
        Outcome::new(state.state().and_then(|state| states.get(state)).and_then(|state| state.end))
    }

    /// Makes the child `C` begin anew in its next visit, as the state that asks for its result is entered.
    pub fn ask_anew<C: 'static>(&self)
    where
        T: Has<C>,
    {
        // A steady tick would visit the child without asking.
        self.store.cycle_state().set_steady(false);
        self.store.cycle_state().request_recheck();
        let state = self.store.component_state::<C>();
        state.begin_anew();
        state.activation().read_period();
    }

    /// Starts `C` again in a visit that is not closed. `before` is what the visit would be otherwise.
    #[cold]
    pub(super) fn begin_anew<C: 'static>(&mut self, before: VisitOutcome) -> VisitOutcome
    where
        T: Has<C>,
    {
        if !before.is_started() {
            self.stop::<C>();
        }
        let now = self.store.cycle_state().now().as_ticks();
        self.store.component_state::<C>().restart(now, const { &policy::<T, C>() });
        VisitOutcome::ENTERED
    }

    /// As [`machine`](Cycle::machine), of a machine with `times`, which stores a number beside the state.
    #[inline]
    #[must_use]
    pub fn counted_machine<C: 'static>(&self, visit: Visit) -> Machine
    where
        T: Has<C>,
    {
        let (state, _) = self.store.component_state::<C>().counted_state();
        Machine { state, entering: visit.entering, moved: false }
    }

    /// Number of transitions with `times` that `C` took in a row.
    #[inline]
    #[must_use]
    pub fn taken<C: 'static>(&self) -> u8
    where
        T: Has<C>,
    {
        self.store.component_state::<C>().counted_state().1
    }

    /// Sets that number after a transition, which was `taken` before it.
    pub fn count<C: 'static>(&self, transition: usize, taken: u8)
    where
        T: Has<C>,
    {
        let transitions = <T::Member as MemberOf<T>>::NODE.transitions;
        self.store.component_state::<C>().count(taken_after(transitions, transition, taken));
    }
}

/// Returns how many transitions with `times` a machine has taken in a row after one more transition; `taken` before it.
///
/// A transition without `times` ends the row, unless it leads back from the state that one with `times` enters to the state which that one
/// leaves.
pub(super) fn taken_after(transitions: &[Transition], index: usize, taken: u8) -> u8 {
    let Some(transition) = transitions.get(index) else { return 0 };
    let is_way_back = |one: &Transition| one.times.is_some() && (one.to, one.from) == (transition.from, transition.to);
    match transition.times {
        Some(_) => taken.saturating_add(1),
        None if transitions.iter().any(is_way_back) => taken,
        None => 0,
    }
}

/// Whether a machine has states with a result.
#[must_use]
pub(super) const fn has_ends(states: &[State]) -> bool {
    has_end(states, Some(End::Done)) || has_end(states, Some(End::Failed))
}

const fn has_end(states: &[State], end: Option<End>) -> bool {
    let mut index = 0;
    while index < states.len() {
        if matches!(
            (states[index].end, end),
            (Some(End::Done), Some(End::Done)) | (Some(End::Failed), Some(End::Failed))
        ) {
            return true;
        }
        index += 1;
    }
    false
}

/// Stops the compiler if the component `C` never ends with this result, or with any; `name` is its type as written.
///
/// # Panics
/// If it does not.
#[track_caller]
pub const fn assert_end<T: Has<C>, C: 'static>(end: Option<End>, name: &str) {
    let states = <T::Member as Component>::STATES;
    let is_there = match end {
        Some(_) => has_end(states, end),
        None => has_ends(states),
    };
    if <T::Member as Component>::IS_STUB || is_there {
        return;
    }
    let word = match end {
        Some(end) => end.word(),
        None => "done",
    };
    let mut text = Text::<256>::new();
    text.push("`");
    text.push(name);
    if states.is_empty() {
        text.push("` is no state machine, so it has no result: name a child with a `#[state(");
        text.push(word);
        text.push(")]`");
    } else if end.is_none() {
        text.push("` has no state with a result: mark its states `#[state(done)]` and `#[state(failed)]`");
    } else {
        text.push("` has no state with this result: mark one of its states `#[state(");
        text.push(word);
        text.push(")]`, or ask for another result");
    }
    panic!("{}", text.as_str());
}
