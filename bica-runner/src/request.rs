//! What operators and tools ask of a running robot.

use bica_core::{ComponentId, Hold, Instant, Tree};

/// A change of the tree from outside, applied between two cycles.
///
/// All changes but the sensor values enter by this type, so a recording of requests and sensor values is complete.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Request {
    /// Holds a component active or latent, or releases it.
    Hold {
        /// The component.
        component: ComponentId,
        /// How it is held from the next tick on.
        hold: Hold,
    },
    /// Modulates the rate of a component.
    Rate {
        /// The component.
        component: ComponentId,
        /// Runs per second, up to the declared rate.
        hz: f32,
    },
}

impl Request {
    pub(crate) fn apply<T: Tree>(self, tree: &mut T) {
        match self {
            Self::Hold { component, hold } => tree.hold_at(component, hold),
            Self::Rate { component, hz } => tree.set_rate_at(component, hz),
        }
    }
}

/// A source of requests: a link to an operator, a script, a recording.
pub trait Requests {
    /// The next request to apply before the cycle at `now`; `None` if there is none left for this cycle.
    fn next(&mut self, now: Instant) -> Option<Request>;
}

/// No requests.
impl Requests for () {
    #[inline]
    fn next(&mut self, _now: Instant) -> Option<Request> {
        None
    }
}

impl<Q: Requests + ?Sized> Requests for &mut Q {
    #[inline]
    fn next(&mut self, now: Instant) -> Option<Request> {
        (**self).next(now)
    }
}

/// A queue, emptied before the next cycle.
#[cfg(feature = "std")]
impl Requests for std::collections::VecDeque<Request> {
    fn next(&mut self, _now: Instant) -> Option<Request> {
        self.pop_front()
    }
}
