//! Watching a tree at work, at no cost where nobody does.

use embassy_time::Instant;

use crate::id::ComponentId;

/// Sees what a tree does; every method does nothing unless written.
///
/// A probe is a type parameter of [`Tree::tick_with`](crate::tree::Tree::tick_with), so what it does not look at costs
/// nothing: with the probe `()` nothing remains in the program.
///
/// A run is one `run`, then one or more stretches of the component's own code, each between a `begin` and an `end`: its
/// transitions, entry and exit hooks and body, but never its children. A probe with a clock reads it in both, or as a
/// [`Stopwatch`](crate::stopwatch::Stopwatch) only once where one stretch follows another. Stretches never overlap. A run
/// has two stretches when a transition is taken: the new state's children come in between.
#[expect(unused_variables, reason = "the names of the arguments are documentation")]
pub trait Probe {
    /// A cycle begins; `now` is what the tree was given.
    #[inline]
    fn cycle_begin(&mut self, now: Instant) {}

    /// The cycle has ended, hooks of components that became latent included.
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

    /// The state machine goes from one state to another: indices in
    /// [`Node::states`](crate::graph::Node::states). Seen after the exit hooks and before the entry hooks.
    #[inline]
    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {}
}

impl Probe for () {}

/// Writes each event of a probe as a call on these probes.
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
            transition(component: ComponentId, from: usize, to: usize) (component, from, to));
    };
    (@ $self:ident [$($probe:expr),+] $event:ident($($arg:ident: $kind:ty),*) $call:tt) => {
        #[inline]
        fn $event(&mut $self $(, $arg: $kind)*) {
            $($probe.$event $call;)+
        }
    };
}

/// A probe that somebody else keeps.
impl<P: Probe> Probe for &mut P {
    forward!(self => (**self));
}

/// Two probes at once.
impl<A: Probe, B: Probe> Probe for (A, B) {
    forward!(self => self.0, self.1);
}
