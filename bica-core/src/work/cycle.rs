//! The jobs of a tree at the beginning and at the end of a cycle, and when the tree is dropped.

use embassy_time::Instant;

use super::WorkSlot;
use crate::id::ComponentId;
use crate::probe::Probe;
use crate::tree::{Has, Layout, Member};

/// What is done with the jobs of one component in a cycle.
struct InCycle<'a, T: Layout, P> {
    slots: &'a T::Slots,
    probe: &'a mut P,
    now: Instant,
    begins: bool,
}

impl<T: Layout, P: Probe> Member<T> for InCycle<'_, T, P> {
    type Output = ();

    fn visit<C: 'static>(self)
    where
        T: Has<C>,
    {
        let (work, id) = (T::slot(self.slots).work(), const { ComponentId::new(T::INDEX) });
        if self.begins {
            if let Some(end) = work.deliver(self.now) {
                self.probe.work_ended(id, end);
            }
        } else if let Some(due) = work.settle(self.now) {
            self.probe.work_begun(id, due);
        }
    }
}

/// Drops the jobs of a component.
struct Cancel<'a, T: Layout>(&'a T::Slots);

impl<T: Layout> Member<T> for Cancel<'_, T> {
    type Output = ();

    fn visit<C: 'static>(self)
    where
        T: Has<C>,
    {
        T::slot(self.0).work().cancel();
    }
}

/// Drops all jobs: slots do not.
#[cold]
pub(crate) fn drop_all<T: Layout>(slots: &T::Slots) {
    for index in 0..T::ORDER.len() {
        T::member(index, Cancel::<T>(slots));
    }
}

/// Delivers the results at the beginning of a cycle, or notes at its end which jobs were begun in it.
#[inline(never)]
pub(crate) fn cycle<T: Layout, P: Probe>(slots: &T::Slots, now: Instant, probe: &mut P, begins: bool) {
    for index in 0..T::ORDER.len() {
        T::member(index, InCycle { slots, probe, now, begins });
    }
}
