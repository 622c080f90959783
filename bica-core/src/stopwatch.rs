//! Measuring how long each component takes.

use embassy_time::Instant;

use crate::id::ComponentId;
use crate::probe::Probe;

/// A probe that measures each of `N` components by a counter: a microcontroller's cycle counter, a processor's time
/// stamp, the nanoseconds since the program began.
///
/// `read` returns the value of the counter. The counter may wrap around. Times stay in its unit, so a read costs no
/// conversion. `N` is [`Tree::COUNT`](crate::tree::Tree::COUNT); components beyond it are not measured.
///
/// Where one component ends and the next begins the counter is read once for both: a chain of ten is measured with
/// eleven reads. So a component is charged with its own code and with its visit by the framework (nanoseconds), never
/// with a child, a hook of another component, or components that were not due. The time of another probe in the same
/// tick is charged to the component that it observes.
///
/// ```
/// use std::time;
///
/// use bica_core::stopwatch::Stopwatch;
/// use bica_core::{Instant, Tree};
/// use bica_macros::{activation_tree, component};
///
/// pub struct Blink { on: bool }
///
/// #[component(crate = bica_core)]
/// impl Blink {
///     pub const fn new() -> Self { Self { on: false } }
///
///     fn step(&mut self) { self.on = !self.on; }
/// }
///
/// activation_tree! {
///     pub struct Light { root: Blink, cycle_hz: 100, components: [Blink], crate: bica_core }
/// }
///
/// let began = time::Instant::now();
/// let mut watch: Stopwatch<_, { Light::COUNT }> = Stopwatch::new(|| began.elapsed().as_nanos() as u64);
/// let mut light = Light::new();
/// for cycle in 0..100 {
///     light.tick_with(Instant::from_millis(10 * cycle), &mut watch);
/// }
/// let spent = watch.of(Light::id::<Blink>()).unwrap();
/// println!("{} ns in {} runs", spent.total, spent.runs);
/// assert_eq!(spent.runs, 100);
/// ```
#[derive(Clone, Debug)]
pub struct Stopwatch<R, const N: usize> {
    read: R,
    mark: u64,
    /// No other code ran since the mark was read.
    fresh: bool,
    spent: [Spent; N],
}

/// Time that a component has spent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// Number of runs.
    pub runs: u64,
    /// Counter ticks in all its runs.
    pub total: u64,
    /// Counter ticks in its last run.
    pub last: u64,
}

impl<R: FnMut() -> u64, const N: usize> Stopwatch<R, N> {
    /// Creates a stopwatch that has measured nothing yet.
    pub const fn new(read: R) -> Self {
        Self { read, mark: 0, fresh: false, spent: [Spent { runs: 0, total: 0, last: 0 }; N] }
    }
}

impl<R, const N: usize> Stopwatch<R, N> {
    /// Returns the time of each component, in the order of the tree's list.
    #[must_use]
    pub const fn spent(&self) -> &[Spent; N] {
        &self.spent
    }

    /// Returns the time of one component; `None` for one that is not measured.
    #[must_use]
    pub fn of(&self, component: ComponentId) -> Option<Spent> {
        self.spent.get(component.index()).copied()
    }

    /// Discards what was measured.
    pub const fn reset(&mut self) {
        self.spent = [Spent { runs: 0, total: 0, last: 0 }; N];
    }
}

impl<R: FnMut() -> u64, const N: usize> Probe for Stopwatch<R, N> {
    #[inline]
    fn cycle_begin(&mut self, _now: Instant) {
        self.fresh = false;
    }

    #[inline]
    fn start(&mut self, _component: ComponentId) {
        self.fresh = false;
    }

    #[inline]
    fn skip(&mut self, _component: ComponentId) {
        self.fresh = false;
    }

    #[inline]
    fn run(&mut self, component: ComponentId) {
        if let Some(spent) = self.spent.get_mut(component.index()) {
            spent.runs += 1;
            spent.last = 0;
        }
    }

    #[inline]
    fn begin(&mut self, _component: ComponentId) {
        if !self.fresh {
            self.mark = (self.read)();
        }
    }

    #[inline]
    fn end(&mut self, component: ComponentId) {
        let now = (self.read)();
        if let Some(spent) = self.spent.get_mut(component.index()) {
            let ticks = now.wrapping_sub(self.mark);
            spent.last = spent.last.wrapping_add(ticks);
            spent.total = spent.total.wrapping_add(ticks);
        }
        self.mark = now;
        self.fresh = true;
    }
}
