//! Watching the loop.

use bica_core::{Instant, Probe, Stopwatch};

use crate::request::Request;
use crate::robot::Robot;
use crate::schedule::Overrun;

/// Sees every input and output of a loop: a recorder, a monitor, a meter.
///
/// An observer is a [`Probe`] too, so it also sees what happens inside the tick. In one cycle the calls come in this
/// order: [`requested`](Self::requested) for each request, [`sensing`](Self::sensing), [`sensed`](Self::sensed), those of
/// the probe from `cycle_begin` to `cycle_end`, [`acted`](Self::acted). An observer with a clock reads it in these calls.
/// Methods that are not written cost nothing. `()` observes nothing; a pair `(A, B)` is two observers.
#[expect(unused_variables, reason = "the names of the arguments are documentation")]
pub trait Observer<R: Robot>: Probe {
    /// A request was applied, before the cycle at `now`.
    #[inline]
    fn requested(&mut self, now: Instant, request: &Request) {}

    /// These sensor values are about to be written into the tree.
    #[inline]
    fn sensing(&mut self, now: Instant, sensors: &R::Sensors<'_>) {}

    /// The sensor values were written, or refused.
    #[inline]
    fn sensed(&mut self) {}

    /// The cycle is complete; its command goes to the world next.
    #[inline]
    fn acted(&mut self, cycle: &Cycle<'_, R>) {}

    /// A real-time loop was still busy when its next cycle was due.
    #[inline]
    fn overrun(&mut self, overrun: &Overrun) {}
}

/// The result of one cycle.
#[derive(Debug)]
pub struct Cycle<'a, R: Robot> {
    /// The instant that the tree was given.
    pub now: Instant,
    /// The tree after the tick: its states and active components.
    pub robot: &'a R,
    /// The command.
    pub command: &'a R::Command,
}

impl<R: Robot> Observer<R> for () {}

/// Measures the components; of the rest of the loop it sees nothing.
impl<R: Robot, C: FnMut() -> u64, const N: usize> Observer<R> for Stopwatch<C, N> {}

/// Writes each call as a call on these observers.
macro_rules! forward {
    ($self:ident => $($observer:expr),+) => {
        #[inline]
        fn requested(&mut $self, now: Instant, request: &Request) {
            $($observer.requested(now, request);)+
        }

        #[inline]
        fn sensing(&mut $self, now: Instant, sensors: &R::Sensors<'_>) {
            $($observer.sensing(now, sensors);)+
        }

        #[inline]
        fn sensed(&mut $self) {
            $($observer.sensed();)+
        }

        #[inline]
        fn acted(&mut $self, cycle: &Cycle<'_, R>) {
            $($observer.acted(cycle);)+
        }

        #[inline]
        fn overrun(&mut $self, overrun: &Overrun) {
            $($observer.overrun(overrun);)+
        }
    };
}

impl<R: Robot, O: Observer<R>> Observer<R> for &mut O {
    forward!(self => (**self));
}

impl<R: Robot, A: Observer<R>, B: Observer<R>> Observer<R> for (A, B) {
    forward!(self => self.0, self.1);
}
