//! Steady ticks: see [`plan`](super::plan).
//!
//! The tree is steady from the end of a cycle in which all conditions of a steady tick hold until the owner requests a
//! hold or a rate, or a tick unwinds. While it is steady, fixed components are marked as active without a parity, and
//! components with the same rate share a grid.

use core::cell::Cell;

use super::borrow::{ExclusiveStore, Store};
use super::component_state::ComponentState;
use super::cycle::Cycle;
use super::layout::{Has, Layout, Member};
use super::plan::GROUPS;
use crate::component::Component;
use crate::hold::Hold;
use crate::probe::Probe;
use crate::rate::{Grid, Period, Tolerance};

/// Grid that all fixed components with one rate share while the tree is steady.
pub(crate) struct SharedGrid {
    origin: Cell<u64>,
    fraction: Cell<u32>,
}

impl SharedGrid {
    #[inline]
    const fn grid(&self) -> Grid<'_> {
        Grid { origin: &self.origin, fraction: &self.fraction }
    }
}

/// The shared grid of each group of a plan.
pub(crate) struct SharedGrids([SharedGrid; GROUPS]);

impl SharedGrids {
    pub(crate) const fn new() -> Self {
        Self([const { SharedGrid { origin: Cell::new(0), fraction: Cell::new(0) } }; GROUPS])
    }

    pub(crate) fn copy_from(&self, other: &Self) {
        for (own, other) in self.0.iter().zip(&other.0) {
            own.grid().set(other.grid());
        }
    }
}

/// Period and tolerance of a group.
#[derive(Clone, Copy)]
struct Timing {
    period: Period,
    tolerance: Tolerance,
}

const fn timings<T: Layout>() -> [Timing; GROUPS] {
    let unused = Timing { period: Period::EVERY_CYCLE, tolerance: Tolerance::new(1.0, None) };
    let (mut timings, mut group) = ([unused; GROUPS], 0);
    while group < T::PLAN.rates().len() {
        let hz = Some(T::PLAN.rates()[group]);
        timings[group] = Timing { period: Period::new(hz), tolerance: Tolerance::new(T::CYCLE_HZ, hz) };
        group += 1;
    }
    timings
}

/// The groups that are due in a cycle, as bits.
#[derive(Clone, Copy)]
pub struct DueGroups(u32);

impl DueGroups {
    /// Whether a component is due; without a group it is.
    #[inline]
    const fn contains(self, group: Option<usize>) -> bool {
        match group {
            Some(group) => self.0 & 1 << group != 0,
            None => true,
        }
    }
}

impl<T: Layout, P: Probe> Cycle<'_, T, P> {
    /// Returns the groups that are due in this steady tick, and moves their grids on.
    #[inline]
    #[must_use]
    pub fn due_groups(&mut self) -> DueGroups {
        let (now, timings) = (self.store.cycle_state().now().as_ticks(), const { &timings::<T>() });
        let grids = self.store.shared_grids().0.iter().zip(timings).take(const { T::PLAN.rates().len() });
        let due = grids.enumerate().fold(0, |due, (group, (shared, timing))| {
            due | u32::from(shared.grid().is_due(now, &timing.period, timing.tolerance)) << group
        });
        DueGroups(due)
    }

    /// Begins the visit of the fixed component `C`; returns whether it is due.
    #[inline]
    #[must_use]
    pub fn visit_steady<C: 'static>(&mut self, due: DueGroups) -> bool
    where
        T: Has<C>,
    {
        let is_due = due.contains(const { T::PLAN.group(T::INDEX) });
        if !is_due {
            self.skip::<C>();
        }
        is_due
    }
}

/// Whether `C` is fixed.
#[must_use]
pub const fn is_fixed<T: Has<C>, C: 'static>() -> bool {
    T::PLAN.is_fixed(T::INDEX)
}

/// Whether the visit of `From` is the first of a steady tick that leads to `To`.
#[must_use]
pub const fn visits_first<T: Has<From> + Has<To>, From: 'static, To: 'static>() -> bool {
    <T as Layout>::PLAN.is_first(<T as Has<From>>::INDEX, <T as Has<To>>::INDEX)
}

impl<T: Layout> Store<T> {
    /// Ends the steady state, because a request changes what it relies on.
    pub(crate) fn unsettle(&self) {
        if const { T::PLAN.exists() } && self.cycle_state().is_steady() {
            self.return_grids();
            let last = self.cycle_state().parity();
            let states = T::ORDER.iter().filter_map(|&index| T::component_state(self.slots(), usize::from(index)));
            states.for_each(|state| state.activation().end_steady(last));
            self.cycle_state().set_steady(false);
            self.cycle_state().request_recheck();
        }
    }

    /// Writes the shared grids back to the components if the tree is steady.
    pub(crate) fn return_grids(&self) {
        if !const { T::PLAN.exists() } || !self.cycle_state().is_steady() {
            return;
        }
        for &index in T::ORDER {
            let index = usize::from(index);
            if let (Some(group), Some(state)) = (T::PLAN.group(index), T::component_state(self.slots(), index)) {
                state.grid().set(self.shared_grids().0[group].grid());
            }
        }
    }
}

/// Whether a component has its declared rate.
struct IsAsDeclared<'a, 't, T: Layout>(&'a ExclusiveStore<'t, T>);

impl<T: Layout> Member<T> for IsAsDeclared<'_, '_, T> {
    type Output = bool;

    fn visit<C: 'static>(self) -> bool
    where
        T: Has<C>,
    {
        self.0.period::<C>().is(const { &Period::new(<T::Member as Component>::HZ) })
    }
}

/// Makes the tree steady at the end of a cycle if all conditions hold.
#[cold]
#[inline(never)]
pub(super) fn become_steady<T: Layout, P: Probe>(cycle: &Cycle<'_, T, P>) {
    let (store, parity) = (&cycle.store, cycle.store.cycle_state().parity());
    let mut known = [false; GROUPS];
    let fixed = || T::ORDER.iter().map(|&index| usize::from(index)).filter(|&index| T::PLAN.is_fixed(index));
    let mut fits = |index: usize, state: &ComponentState| {
        let activation = state.activation();
        let is_usual = activation.held() == Hold::Tree && activation.is_visited_as_before(parity);
        if !is_usual || T::member(index, IsAsDeclared(store)) != Some(true) {
            return false;
        }
        let Some(group) = T::PLAN.group(index) else { return true };
        let shared = store.shared_grids().0[group].grid();
        if !core::mem::replace(&mut known[group], true) {
            shared.set(state.grid());
        }
        shared == state.grid()
    };
    if fixed().all(|index| store.state_at(index).is_some_and(|state| fits(index, state))) {
        fixed().filter_map(|index| store.state_at(index)).for_each(|state| state.activation().become_steady());
        store.cycle_state().set_steady(true);
    }
}
