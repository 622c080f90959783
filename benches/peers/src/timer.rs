//! Timestamps around each component, for designs without timing of their own.

/// Measurement around the code of a component.
pub trait Timer {
    /// Runs the code of component `part`.
    fn time<T>(&mut self, part: usize, work: impl FnOnce() -> T) -> T;
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
