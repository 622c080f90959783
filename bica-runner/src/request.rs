//! Requests of operators and tools to a running robot.

use bica_core::{ComponentId, Hold, Instant, Tree};

/// Change of the tree from outside, applied between two cycles.
///
/// All changes except the sensor values are requests, so a recording of requests and sensor values is complete.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Request {
    /// Holds a component active or latent, or releases it.
    Hold {
        /// Component.
        component: ComponentId,
        /// Hold from the next tick on.
        hold: Hold,
    },
    /// Changes the rate of a component.
    Rate {
        /// Component.
        component: ComponentId,
        /// Runs per second, limited to the declared rate.
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

/// Source of requests: a link to an operator, a script, a recording.
pub trait Requests {
    /// Returns the next request to apply before the cycle at `now`; `None` if there is no further one for this cycle.
    fn next(&mut self, now: Instant) -> Option<Request>;
}

/// Provides no requests.
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

/// Queue of requests; all are applied before the next cycle.
#[cfg(feature = "std")]
impl Requests for std::collections::VecDeque<Request> {
    fn next(&mut self, _now: Instant) -> Option<Request> {
        self.pop_front()
    }
}
