//! Who runs the jobs of a robot's components, and when their results arrive.

use bica_core::work::{Visitor, WorkOf, WorkSlot, visit};
use bica_core::{ComponentId, Has, Instant, Tree};

/// Runs the jobs of a robot's components; see the module [`work`](bica_core::work).
///
/// `()` leaves them to the tree: simulated time, in which a cycle runs a job when it is due. A loop in real time has `Workers` (feature
/// `std`) or [`IdleTime`] instead.
pub trait Jobs<T: Tree> {
    /// Puts results back that are to be there in the cycle at `now`. Called before the tick.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn deliver(&mut self, now: Instant, tree: &T) {}

    /// Takes the jobs that were begun. Called after the tick.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn collect(&mut self, tree: &T) {}

    /// Runs a part of a job between two cycles; returns whether there was one.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn idle(&mut self, tree: &T) -> bool {
        false
    }
}

impl<T: Tree> Jobs<T> for () {}

/// Runs jobs slice by slice in the idle time between two cycles, as [`Runner::run_async`](crate::Runner) does on a microcontroller. Work
/// without slices is one slice.
#[derive(Clone, Copy, Debug, Default)]
pub struct IdleTime;

impl<T: Tree> Jobs<T> for IdleTime {
    fn collect(&mut self, tree: &T) {
        visit(tree, &mut Claim);
    }

    fn idle(&mut self, tree: &T) -> bool {
        let mut slice = Slice(false);
        visit(tree, &mut slice);
        slice.0
    }
}

struct Claim;

impl<T: Tree> Visitor<T> for Claim {
    fn visit<C: 'static>(&mut self, _: ComponentId, slot: &WorkOf<T, C>)
    where
        T: Has<C>,
    {
        slot.claim();
    }
}

/// Runs one slice of the first job; whether it did.
struct Slice(bool);

impl<T: Tree> Visitor<T> for Slice {
    fn visit<C: 'static>(&mut self, _: ComponentId, slot: &WorkOf<T, C>)
    where
        T: Has<C>,
    {
        self.0 = self.0 || slot.slice();
    }
}
