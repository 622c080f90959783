//! Observing a running tree, at no cost without an observer.

use embassy_time::Instant;

use crate::id::ComponentId;
use crate::work::JobEnd;

/// Observer of a tree; every method does nothing unless implemented.
///
/// A probe is a type parameter of [`Tree::tick_with`](crate::tree::Tree::tick_with), so an event that it ignores
/// costs nothing: with the probe `()` nothing remains in the program.
///
/// A run is one `run`, then one or more sections of the component's own code, each between a `begin` and an `end`: its
/// transitions, entry and exit hooks and function, but never its children. A probe with a clock reads it in both, or as a
/// [`Stopwatch`](crate::stopwatch::Stopwatch) only once where one section follows another. Sections never overlap. A run
/// has two sections when a transition is taken: the new state's children are visited in between.
#[expect(unused_variables, reason = "the names of the arguments are documentation")]
pub trait Probe {
    /// A cycle begins; `now` is the instant given to the tick.
    #[inline]
    fn cycle_begin(&mut self, now: Instant) {}

    /// The cycle has ended, including the hooks of components that became latent.
    #[inline]
    fn cycle_end(&mut self) {}

    /// The component became active.
    #[inline]
    fn start(&mut self, component: ComponentId) {}

    /// The component became latent.
    #[inline]
    fn stop(&mut self, component: ComponentId) {}

    /// The component was visited and is not due.
    #[inline]
    fn skip(&mut self, component: ComponentId) {}

    /// The component runs; what it requires has been visited.
    #[inline]
    fn run(&mut self, component: ComponentId) {}

    /// The component's own code begins.
    #[inline]
    fn begin(&mut self, component: ComponentId) {}

    /// The component's own code has ended.
    #[inline]
    fn end(&mut self, component: ComponentId) {}

    /// The condition of a transition was evaluated: its index in [`Node::transitions`](crate::graph::Node::transitions), and
    /// whether it holds: one that returns an `Option` holds if it found something. A condition is not evaluated while its timer
    /// runs, or if an earlier one holds. Called within a section.
    #[inline]
    fn condition(&mut self, component: ComponentId, transition: usize, holds: bool) {}

    /// The component began a job in this cycle, which is due at `due`. Called at the end of the cycle.
    #[inline]
    fn work_begun(&mut self, component: ComponentId, due: Instant) {}

    /// The job of the component has ended; its result, if it has one, is there in this cycle. Called at the beginning of the cycle.
    #[inline]
    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {}

    /// The state machine takes a transition from one state to another: indices in
    /// [`Node::states`](crate::graph::Node::states). Called after the exit hooks and before the entry hooks.
    #[inline]
    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {}
}

impl Probe for () {}

/// Writes each event of a probe as a call on those of these probes that there are.
macro_rules! forward {
    ($self:ident => $($probe:expr),+) => {
        forward!(@ $self [$($probe),+] cycle_begin(now: Instant) (now));
        forward!(@ $self [$($probe),+] cycle_end() ());
        forward!(@ $self [$($probe),+] start(component: ComponentId) (component));
        forward!(@ $self [$($probe),+] stop(component: ComponentId) (component));
        forward!(@ $self [$($probe),+] skip(component: ComponentId) (component));
        forward!(@ $self [$($probe),+] run(component: ComponentId) (component));
        forward!(@ $self [$($probe),+] begin(component: ComponentId) (component));
        forward!(@ $self [$($probe),+] end(component: ComponentId) (component));
        forward!(@ $self [$($probe),+]
            condition(component: ComponentId, transition: usize, holds: bool) (component, transition, holds));
        forward!(@ $self [$($probe),+] work_begun(component: ComponentId, due: Instant) (component, due));
        forward!(@ $self [$($probe),+] work_ended(component: ComponentId, end: JobEnd) (component, end));
        forward!(@ $self [$($probe),+]
            transition(component: ComponentId, from: usize, to: usize) (component, from, to));
    };
    (@ $self:ident [$($probe:expr),+] $event:ident($($arg:ident: $kind:ty),*) $call:tt) => {
        #[inline]
        fn $event(&mut $self $(, $arg: $kind)*) {
            $(if let Some(probe) = $probe {
                probe.$event $call;
            })+
        }
    };
}

/// A borrowed probe.
impl<P: Probe> Probe for &mut P {
    forward!(self => Some(&mut **self));
}

/// A probe, if there is one.
impl<P: Probe> Probe for Option<P> {
    forward!(self => self);
}

/// Two probes at once.
impl<A: Probe, B: Probe> Probe for (A, B) {
    forward!(self => Some(&mut self.0), Some(&mut self.1));
}
