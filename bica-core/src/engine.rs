//! A tree in being: its components and what is remembered from cycle to cycle.

use embassy_time::Instant;

use crate::cycle::Cycle;
use crate::hold::Hold;
use crate::id::ComponentId;
use crate::loan::Store;
use crate::probe::Probe;
use crate::set::Set;
use crate::tree::Layout;

/// A tree in being. All sets are numbered by rank, so that the lowest number is the first activator.
pub struct Engine<T: Layout> {
    pub(crate) store: Store<T>,
    active: T::Set,
    latent: T::Set,
    forced: T::Set,
}

impl<T: Layout> Engine<T> {
    /// Takes the slots in; nothing is active yet.
    pub const fn new(slots: T::Slots) -> Self {
        Self { store: Store::new(slots), active: T::Set::EMPTY, latent: T::Set::EMPTY, forced: T::Set::EMPTY }
    }

    /// One cycle.
    #[inline]
    pub(crate) fn tick<P: Probe>(&mut self, now: Instant, probe: &mut P) {
        probe.cycle_begin(now);
        let key = self.store.open();
        let mut cycle = Cycle { key, now, before: self.active, closed: self.latent, probe };
        T::visit_root(&mut cycle);
        let mut forced = self.forced.without(&cycle.closed);
        while let Some(index) = first::<T>(&mut forced) {
            T::visit(&mut cycle, index);
        }
        let active = cycle.closed.without(&self.latent);
        let mut ended = self.active.without(&active);
        while let Some(index) = first::<T>(&mut ended) {
            T::stop(&mut cycle, index);
        }
        self.active = active;
        cycle.probe.cycle_end();
    }

    pub(crate) fn hold(&mut self, component: ComponentId, hold: Hold) {
        if let Some(&rank) = T::RANKS.get(component.index()) {
            self.latent.remove(rank);
            self.forced.remove(rank);
            match hold {
                Hold::Tree => {}
                Hold::Active => _ = self.forced.insert(rank),
                Hold::Latent => _ = self.latent.insert(rank),
            }
        }
    }

    pub(crate) fn held(&self, component: ComponentId) -> Hold {
        match T::RANKS.get(component.index()) {
            Some(&rank) if self.forced.contains(rank) => Hold::Active,
            Some(&rank) if self.latent.contains(rank) => Hold::Latent,
            _ => Hold::Tree,
        }
    }

    pub(crate) fn is_active(&self, component: ComponentId) -> bool {
        T::RANKS.get(component.index()).is_some_and(|&rank| self.active.contains(rank))
    }
}

/// Takes the component of the lowest rank out of a set.
fn first<T: Layout>(set: &mut T::Set) -> Option<usize> {
    T::ORDER.get(set.pop()?).copied()
}
