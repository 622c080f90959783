//! Steady ticks: see [`plan`](super::plan).

use super::deferred::is_deferred;
use super::layout::{Cycle, Has, Layout, Store, visits_at_rate};
use crate::probe::Probe;

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Begins the visit of the fixed component `C` in a steady tick; returns whether it is due.
    #[inline]
    #[must_use]
    pub fn visit_steady<C: 'static>(&mut self) -> bool
    where
        T: Has<C>,
    {
        if !const { T::PLANS.is_whole() } {
            self.store.component_state::<C>().activation().visit(self.store.cycle_state().parity());
        }
        let is_due = !const { visits_at_rate::<T, C>() } || self.is_due::<C>();
        if !is_due {
            self.skip::<C>();
        }
        is_due
    }
}

/// Whether `C` is fixed in plan `plan`.
#[must_use]
pub const fn is_fixed<T: Has<C>, C: 'static>(plan: usize) -> bool {
    T::PLANS.is_fixed(plan, T::INDEX)
}

/// Whether in plan `plan` the visit of `From` is the first of a steady tick that leads to `To`, or puts its visit off.
#[must_use]
pub const fn visits_first<T: Has<From> + Has<To>, From: 'static, To: 'static>(plan: usize) -> bool {
    is_deferred::<T, To>() || <T as Layout>::PLANS.is_first(plan, <T as Has<From>>::INDEX, <T as Has<To>>::INDEX)
}

impl<T: Layout> Store<T> {
    /// Records that a request changes what steady ticks rely on.
    pub(crate) fn leave_steady(&self) {
        if const { T::PLANS.exist() } {
            self.cycle_state().set_steady(false);
            self.cycle_state().request_recheck();
        }
    }
}

/// Makes the next tick steady if in this cycle every fixed component was visited and need not read its period.
#[cold]
#[inline(never)]
pub(super) fn become_steady<T: Layout, P: Probe>(cycle: &Cycle<'_, T, P>) {
    let (store, parity) = (&cycle.store, cycle.store.cycle_state().parity());
    let Some(root) = T::ORDER.first().and_then(|&root| store.state_at(usize::from(root))) else { return };
    let plan = root.state().unwrap_or(0);
    let mut fixed = T::ORDER.iter().map(|&index| usize::from(index)).filter(|&index| T::PLANS.is_fixed(plan, index));
    let is_steady =
        fixed.all(|index| store.state_at(index).is_some_and(|state| state.activation().is_visited_as_before(parity)));
    store.cycle_state().set_steady(is_steady);
}
