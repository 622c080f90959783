//! Observers of the loop.

use bica_core::refusal::Refusal;
use bica_core::{Instant, Probe, Stopwatch};

use crate::clock::ClockStep;
use crate::request::Request;
use crate::robot::Robot;
use crate::schedule::Overrun;

/// Receives every input and output of a loop, for example for a recording, a monitor or a measurement.
///
/// An observer is a [`Probe`] too, so it also receives the events within the tick. The calls of one cycle have this
/// order: [`requested`](Self::requested) or [`refused`](Self::refused) for each request, [`sensing`](Self::sensing),
/// [`sensed`](Self::sensed), those of the probe from `cycle_begin` to `cycle_end`, [`acted`](Self::acted). An observer
/// that measures time reads its clock in these calls. Methods with their default implementation cost nothing. `()`
/// observes nothing, an `Option` may be no observer, and a pair `(A, B)` is two.
#[expect(unused_variables, reason = "the names of the arguments are documentation")]
pub trait Observer<R: Robot>: Probe {
    /// Called before the cycle at `now` at which the world's clock made its first step.
    #[inline]
    fn clock_stepped(&mut self, now: Instant, step: &ClockStep) {}

    /// Called after a request was applied, before the cycle at `now`.
    #[inline]
    fn requested(&mut self, now: Instant, request: &Request<'_>) {}

    /// Called after the tree refused a request, which changed nothing.
    #[inline]
    fn refused(&mut self, now: Instant, request: &Request<'_>, refusal: &Refusal) {}

    /// Called before these sensor values are written into the tree.
    #[inline]
    fn sensing(&mut self, now: Instant, sensors: &R::Sensors<'_>) {}

    /// Called after the sensor values were written or rejected.
    #[inline]
    fn sensed(&mut self) {}

    /// Called at the end of the cycle, before the command is passed to the world.
    #[inline]
    fn acted(&mut self, cycle: &Cycle<'_, R>) {}

    /// Called after requests were applied without a cycle, at the instant of the next one.
    #[inline]
    fn requests_applied(&mut self, now: Instant, robot: &R) {}

    /// Called when a cycle of a real-time loop ended after the next one was due.
    #[inline]
    fn overrun(&mut self, overrun: &Overrun) {}
}

/// Result of one cycle.
#[derive(Debug)]
pub struct Cycle<'a, R: Robot> {
    /// Instant of the tick.
    pub now: Instant,
    /// Tree after the tick: its states and active components.
    pub robot: &'a R,
    /// Command.
    pub command: &'a R::Command,
}

impl<R: Robot> Observer<R> for () {}

/// Measures the components; it does not use the other calls of the loop.
impl<R: Robot, C: FnMut() -> u64, const N: usize> Observer<R> for Stopwatch<C, N> {}

/// Implements each method by a call of the same method of those of these observers that there are.
macro_rules! forward {
    ($self:ident => $($observer:expr),+) => {
        #[inline]
        fn clock_stepped(&mut $self, now: Instant, step: &ClockStep) {
            $(if let Some(observer) = $observer {
                observer.clock_stepped(now, step);
            })+
        }

        #[inline]
        fn requested(&mut $self, now: Instant, request: &Request<'_>) {
            $(if let Some(observer) = $observer {
                observer.requested(now, request);
            })+
        }

        #[inline]
        fn refused(&mut $self, now: Instant, request: &Request<'_>, refusal: &Refusal) {
            $(if let Some(observer) = $observer {
                observer.refused(now, request, refusal);
            })+
        }

        #[inline]
        fn sensing(&mut $self, now: Instant, sensors: &R::Sensors<'_>) {
            $(if let Some(observer) = $observer {
                observer.sensing(now, sensors);
            })+
        }

        #[inline]
        fn sensed(&mut $self) {
            $(if let Some(observer) = $observer {
                observer.sensed();
            })+
        }

        #[inline]
        fn acted(&mut $self, cycle: &Cycle<'_, R>) {
            $(if let Some(observer) = $observer {
                observer.acted(cycle);
            })+
        }

        #[inline]
        fn requests_applied(&mut $self, now: Instant, robot: &R) {
            $(if let Some(observer) = $observer {
                observer.requests_applied(now, robot);
            })+
        }

        #[inline]
        fn overrun(&mut $self, overrun: &Overrun) {
            $(if let Some(observer) = $observer {
                observer.overrun(overrun);
            })+
        }
    };
}

impl<R: Robot, O: Observer<R>> Observer<R> for &mut O {
    forward!(self => Some(&mut **self));
}

impl<R: Robot, O: Observer<R>> Observer<R> for Option<O> {
    forward!(self => self);
}

impl<R: Robot, A: Observer<R>, B: Observer<R>> Observer<R> for (A, B) {
    forward!(self => Some(&mut self.0), Some(&mut self.1));
}
