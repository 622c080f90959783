//! The cycles of a tree.

use core::mem;

use embassy_time::Instant;

use super::component_state::ComponentState;
use super::deferred::visit_deferred;
use super::going;
use super::layout::{Cycle, Engine, Layout, Store};
use super::steady::become_steady;
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::probe::Probe;
use crate::work;

impl<T: Layout> Engine<T> {
    /// Takes the components; none is active yet.
    // A call of its own would have one copy more of the tree on the stack in builds without optimisation across modules.
    #[inline]
    pub const fn new(slots: T::Slots) -> Self {
        Self { store: Store::new(slots) }
    }

    /// Runs one cycle.
    #[inline]
    pub(crate) fn tick<P: Probe>(&mut self, now: Instant, probe: &mut P) {
        probe.cycle_begin(now);
        // Before the cycle state changes: if a job unwinds here, no cycle was begun.
        if const { T::WORKS } {
            work::cycle::<T, P>(self.store.slots(), now, probe, true);
        }
        self.store.cycle_state().begin(now, const { T::PLANS.is_whole() });
        let mut cycle = Cycle { store: self.store.open(), probe };
        if !const { T::PLANS.exist() } {
            T::visit_root(&mut cycle);
        } else if cycle.store.cycle_state().is_steady() {
            T::run_steady(&mut cycle);
        } else {
            visit_root(&mut cycle);
        }
        if const { T::DEFERS } {
            visit_last(&mut cycle);
        }
        if !cycle.store.cycle_state().is_settled() {
            update_active(&mut cycle);
        }
        if const { T::WORKS } {
            work::cycle::<T, P>(cycle.store.slots(), now, cycle.probe, false);
        }
        cycle.probe.cycle_end();
        // Dropping a cycle marks the tree as interrupted.
        mem::forget(cycle);
    }

    pub(crate) fn hold(&mut self, component: ComponentId, hold: Hold) {
        self.store.leave_steady();
        let cycle_state = self.store.cycle_state();
        let Some(activation) = self.component_state(component).map(ComponentState::activation) else { return };
        cycle_state.hold(activation.held(), hold);
        activation.hold(hold, cycle_state.parity());
    }

    pub(crate) fn is_active(&self, component: ComponentId) -> bool {
        let last = self.store.cycle_state().parity();
        self.component_state(component).is_some_and(|state| state.activation().is_active(last))
    }

    fn component_state(&self, component: ComponentId) -> Option<&ComponentState> {
        T::component_state(self.store.slots(), component.index())
    }
}

impl<T: Layout> Drop for Engine<T> {
    fn drop(&mut self) {
        if const { T::WORKS } {
            work::drop_all::<T>(self.store.slots());
        }
    }
}

/// The indices of the components, activators before what they activate.
fn order<T: Layout>() -> impl Iterator<Item = usize> {
    T::ORDER.iter().map(|&index| usize::from(index))
}

/// Visits all components, as a function of its own beside the steady tick.
#[inline(never)]
fn visit_root<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    T::visit_root(cycle);
}

/// Visits what is held active, and then what was put off to the end of the cycle.
fn visit_last<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    let held_active = cycle.store.cycle_state().held_active();
    if held_active > 0 {
        visit_held_active(cycle, held_active);
    }
    visit_deferred(cycle);
}

/// Visits what is held active, and stops what is not active any more.
#[inline]
fn update_active<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    let held_active = cycle.store.cycle_state().held_active();
    if held_active > 0 && !const { T::DEFERS } {
        visit_held_active(cycle, held_active);
    }
    if cycle.store.cycle_state().takes_recheck() {
        if going::IS_POSSIBLE {
            cycle.store.cycle_state().ends_going();
        }
        stop_unvisited(cycle);
        if const { T::PLANS.exist() } && !cycle.store.cycle_state().is_steady() {
            become_steady(cycle);
        }
    }
}

/// Visits the components that are held active and were not reached; `held` is their number.
#[cold]
#[inline(never)]
fn visit_held_active<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>, mut held: u16) {
    for index in order::<T>() {
        if cycle.store.state_at(index).is_some_and(|state| state.activation().held() == Hold::Active) {
            T::visit(cycle, index);
            held -= 1;
            if held == 0 {
                return;
            }
        }
    }
}

/// Stops the components that were active in the previous cycle and were not visited in this one, activators first.
#[cold]
#[inline(never)]
fn stop_unvisited<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    let (previous, parity) = (cycle.store.cycle_state().previous(), cycle.store.cycle_state().parity());
    for index in order::<T>() {
        if cycle.store.state_at(index).is_some_and(|state| state.activation().end_unless_visited(previous, parity)) {
            T::stop(cycle, index);
        }
    }
}

/// Marks all active components: the tick unwinds.
#[cold]
pub(super) fn interrupt<T: Layout, P>(cycle: &Cycle<'_, T, P>) {
    order::<T>().filter_map(|index| cycle.store.state_at(index)).for_each(|state| state.activation().interrupt());
    cycle.store.cycle_state().interrupt();
}

/// Stops what was active when the last tick unwound, activators first, and discards its history.
#[cold]
#[inline(never)]
pub(super) fn stop_interrupted<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    cycle.store.cycle_state().recover();
    for index in order::<T>() {
        if let Some(state) = cycle.store.state_at(index)
            && state.activation().end_if_interrupted()
        {
            state.discard_history();
            T::stop(cycle, index);
        }
    }
}
