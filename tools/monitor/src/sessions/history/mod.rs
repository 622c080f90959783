//! History of a session.

mod images;
mod jobs;
mod outputs;
mod part;
mod states;
mod timed;
mod timeline;
mod told;
mod truths;

use std::collections::BTreeMap;

use bica_link::Description;
use bica_wire::message::LogLine;

use crate::protocol::Costs;

pub(super) use images::Images;
pub(super) use outputs::OutputStore;
#[cfg(test)]
pub(super) use states::free;
pub(super) use states::{Change, States};
pub(super) use timed::Timed;
pub(super) use told::Told;
pub(super) use truths::Truths;

/// For each transition of a component: whether its condition holds, and since when, µs; none if it was not evaluated.
pub(super) type Conditions = Vec<Option<(bool, u64)>>;

/// Limits of the history.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Limits {
    /// Largest age, µs; none for a recording.
    pub(super) ring_us: Option<u64>,
    /// Memory of outputs, bytes.
    pub(super) output_bytes: usize,
    /// Memory of images, bytes.
    pub(super) image_bytes: usize,
}

/// History of a session: the last minutes of a robot, or a recording.
#[derive(Debug, Default)]
pub(super) struct History {
    limits: Limits,
    pub(super) states: States,
    pub(super) outputs: OutputStore,
    pub(super) images: Images,
    /// Entries of the log.
    pub(super) told: Timed<Told>,
    pub(super) truths: Truths,
    pub(super) costs: Timed<Costs>,
    /// Changes of the conditions of each component; `None` is the beginning of a time in which they are not received.
    conditions: BTreeMap<usize, Timed<Option<Conditions>>>,
    /// Components, at the times of runs that took longer than the budget.
    pub(super) overruns: Timed<u16>,
    /// Transitions that were taken: component and index. They are received over a link that offers conditions.
    pub(super) taken: Timed<(usize, usize)>,
}

impl History {
    pub(super) fn new(limits: Limits, components: usize) -> Self {
        Self { limits, states: States::new(components), images: Images::new(limits.image_bytes), ..Self::default() }
    }

    /// Returns the first and the last time with a known state, µs.
    pub(super) fn span(&self) -> (u64, u64) {
        self.states.span()
    }

    /// Begins a gap, which ends with the next cycle that is added.
    pub(super) fn interrupt(&mut self) {
        self.states.interrupt();
        self.outputs.interrupt();
        let time_us = self.span().1;
        self.conditions.values_mut().for_each(|known| known.push(time_us, None));
    }

    /// Returns the memory of outputs and images, bytes.
    pub(super) const fn bytes(&self) -> usize {
        self.outputs.bytes() + self.images.bytes()
    }

    /// Returns the last lines of the log in an interval, oldest first, with the names of the tree.
    pub(super) fn lines(&self, from_us: u64, until_us: u64, limit: usize, tree: &Description) -> Vec<LogLine<String>> {
        let last = self.told.between(from_us, until_us).rev().take(limit);
        let mut lines: Vec<_> = last.map(|(time_us, told)| told.line(*time_us, tree)).collect();
        lines.reverse();
        lines
    }

    /// Adds the conditions of a component; none if they are no longer received.
    pub(super) fn add_conditions(&mut self, time_us: u64, component: usize, conditions: Option<Conditions>) {
        let known = self.conditions.entry(component).or_default();
        if known.newest().is_none_or(|(_, last)| *last != conditions) {
            known.push(time_us, conditions);
        }
    }

    /// Returns the conditions of a component at a time, µs.
    pub(super) fn conditions(&self, component: usize, time_us: u64) -> Option<&Conditions> {
        self.conditions.get(&component)?.at(time_us)?.1.as_ref()
    }

    /// Removes data that are older than the limit, and outputs that exceed their memory.
    pub(super) fn evict(&mut self) {
        let (first, last) = self.span();
        if let Some(ring) = self.limits.ring_us {
            let horizon = last.saturating_sub(ring);
            self.states.evict(horizon);
            self.outputs.evict(horizon);
            self.images.evict(horizon);
            self.told.evict(horizon);
            self.truths.evict(horizon);
            self.costs.evict(horizon);
            self.overruns.evict(horizon);
            self.taken.evict(horizon);
            self.conditions.values_mut().for_each(|known| known.evict_states(horizon));
        }
        let mut horizon = first;
        while self.outputs.bytes() > self.limits.output_bytes && horizon < last {
            horizon += ((last - first) / 8).max(1);
            self.outputs.evict(horizon);
        }
    }
}
