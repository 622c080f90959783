//! Timestamps around each component, for those who bring no timing of their own.

/// What is done around a component's own code.
pub trait Timer {
    /// Does the work of component `part`.
    fn time<T>(&mut self, part: usize, work: impl FnOnce() -> T) -> T;
}

/// Nothing.
impl Timer for () {
    #[inline]
    fn time<T>(&mut self, _part: usize, work: impl FnOnce() -> T) -> T {
        work()
    }
}

/// Reads a counter before and after, and adds up the difference for each of `N` components.
pub struct Pairs<R, const N: usize> {
    read: R,
    spent: [u64; N],
}

impl<R, const N: usize> Pairs<R, N> {
    /// Has measured nothing yet.
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
