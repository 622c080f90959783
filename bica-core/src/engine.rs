//! A tree in being: its components and what is remembered from cycle to cycle.

use embassy_time::Instant;

use crate::clock::Clock;
use crate::cycle::Cycle;
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::loan::Store;
use crate::probe::Probe;
use crate::tree::Layout;

/// A tree in being.
pub struct Engine<T: Layout> {
    pub(crate) store: Store<T>,
    /// How many components are held active.
    forced: usize,
}

impl<T: Layout> Engine<T> {
    /// Takes the slots in; nothing is active yet.
    pub const fn new(slots: T::Slots) -> Self {
        Self { store: Store::new(slots), forced: 0 }
    }

    /// One cycle.
    #[inline]
    pub(crate) fn tick<P: Probe>(&mut self, now: Instant, probe: &mut P) {
        probe.cycle_begin(now);
        self.store.pulse().begin(now);
        let mut cycle = Cycle { key: self.store.open(), probe };
        T::visit_root(&mut cycle);
        if self.forced > 0 {
            force(&mut cycle, self.forced);
        }
        if cycle.key.pulse().may_have_changed() {
            settle(&mut cycle);
        }
        cycle.probe.cycle_end();
    }

    pub(crate) fn hold(&mut self, component: ComponentId, hold: Hold) {
        let pulse = self.store.pulse();
        let Some(mark) = self.clock(component).map(Clock::mark) else { return };
        let before = mark.held();
        mark.hold(hold, pulse.beat());
        pulse.unsettle();
        self.forced = self.forced + usize::from(hold == Hold::Active) - usize::from(before == Hold::Active);
    }

    pub(crate) fn held(&self, component: ComponentId) -> Hold {
        self.clock(component).map_or(Hold::Tree, |clock| clock.mark().held())
    }

    pub(crate) fn is_active(&self, component: ComponentId) -> bool {
        self.clock(component).is_some_and(|clock| clock.mark().is_active(self.store.pulse().beat()))
    }

    fn clock(&self, component: ComponentId) -> Option<&Clock> {
        T::clock(self.store.slots(), component.index())
    }
}

/// Visits what is held active and was not reached; so many are held.
#[cold]
fn force<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>, mut held: usize) {
    for index in T::ORDER.iter().map(|&index| usize::from(index)) {
        if cycle.key.clock_at(index).is_some_and(|clock| clock.mark().held() == Hold::Active) {
            T::visit(cycle, index);
            held -= 1;
            if held == 0 {
                return;
            }
        }
    }
}

/// Stops what was active in the cycle before and is not any more, activators first.
#[cold]
fn settle<T: Layout, P: Probe>(cycle: &mut Cycle<'_, T, P>) {
    let before = cycle.key.pulse().before();
    for index in T::ORDER.iter().map(|&index| usize::from(index)) {
        if cycle.key.clock_at(index).is_some_and(|clock| clock.mark().has_ended(before)) {
            T::stop(cycle, index);
        }
    }
}
