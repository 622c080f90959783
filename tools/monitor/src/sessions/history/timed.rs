//! Values with their times.

use std::collections::VecDeque;

/// Largest number of values; beyond it the oldest are removed.
const MAX_VALUES: usize = 100_000;

/// Values with their times, µs, the oldest first.
#[derive(Debug)]
pub(crate) struct Timed<T>(VecDeque<(u64, T)>);

impl<T> Default for Timed<T> {
    fn default() -> Self {
        Self(VecDeque::new())
    }
}

impl<T> Timed<T> {
    /// Adds a value. It may be older than the last one: a link reports overruns of all components at the end of a window.
    pub(crate) fn push(&mut self, time_us: u64, value: T) {
        if self.0.len() >= MAX_VALUES {
            self.0.pop_front();
        }
        let later = self.0.iter().rev().take_while(|(other, _)| *other > time_us).count();
        self.0.insert(self.0.len() - later, (time_us, value));
    }

    /// Returns the last value that is not later than a time, µs.
    pub(crate) fn at(&self, time_us: u64) -> Option<&(u64, T)> {
        let end = self.0.partition_point(|(time, _)| *time <= time_us);
        self.0.get(end.checked_sub(1)?)
    }

    pub(crate) fn newest(&self) -> Option<&(u64, T)> {
        self.0.back()
    }

    /// Returns the values of an interval, both ends included.
    pub(crate) fn between(&self, from_us: u64, until_us: u64) -> impl DoubleEndedIterator<Item = &(u64, T)> {
        let end = self.0.partition_point(|(time, _)| *time <= until_us);
        let begin = self.0.partition_point(|(time, _)| *time < from_us).min(end);
        self.0.range(begin..end)
    }

    /// Removes the values before `horizon`.
    pub(super) fn evict(&mut self, horizon: u64) {
        self.0.drain(..self.0.partition_point(|(time, _)| *time < horizon));
    }

    /// Removes the values before `horizon`, except the last one at or before it, which is valid at that time.
    pub(super) fn evict_states(&mut self, horizon: u64) {
        let time_us = self.at(horizon).map_or(horizon, |(time, _)| *time);
        self.evict(time_us);
    }
}
