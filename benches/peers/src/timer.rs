//! Timestamps around each component, for designs without timing of their own.

/// Measurement around the code of a component.
pub trait Timer {
    /// Runs the code of component `part`.
    fn time<T>(&mut self, part: usize, work: impl FnOnce() -> T) -> T;
}

/// Reads the counter that Copper reads.
#[cfg(feature = "copper")]
pub use cu29::clock::read_raw_counter as counter;

/// Without Copper: ns.
#[cfg(not(feature = "copper"))]
#[must_use]
pub fn counter() -> u64 {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed().as_nanos() as u64
}

/// No measurement.
impl Timer for () {
    #[inline]
    fn time<T>(&mut self, _part: usize, work: impl FnOnce() -> T) -> T {
        work()
    }
}

/// Reads a counter before and after each of `N` components and adds up the differences.
pub struct Pairs<R, const N: usize> {
    read: R,
    spent: [u64; N],
}

impl<R, const N: usize> Pairs<R, N> {
    /// Creates a timer without measurements.
    pub const fn new(read: R) -> Self {
        Self { read, spent: [0; N] }
    }
}

impl<R: Fn() -> u64, const N: usize> Timer for Pairs<R, N> {
    #[inline]
    fn time<T>(&mut self, part: usize, work: impl FnOnce() -> T) -> T {
        let began = (self.read)();
        let result = work();
        let ticks = (self.read)().wrapping_sub(began);
        if let Some(spent) = self.spent.get_mut(part) {
            *spent = spent.wrapping_add(ticks);
        }
        result
    }
}
