//! States of all components over time.

use std::collections::VecDeque;

use crate::protocol::ComponentNow;
use bica::Hold;
use bica_wire::message::ComponentState;

/// A change of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Change {
    /// Time of the first cycle with the change, µs.
    pub(crate) time_us: u64,
    /// Component.
    pub(crate) component: u16,
    /// Whether activation or state changed; otherwise only hold or rate.
    pub(crate) visible: bool,
    /// The state from then on.
    pub(crate) now: ComponentNow,
}

/// States of all components over time, exact to the cycle.
#[derive(Debug, Default)]
pub(crate) struct States {
    /// States before the first change in memory.
    base: Vec<ComponentNow>,
    changes: VecDeque<Change>,
    current: Vec<ComponentNow>,
    /// Time, µs, and number of each cycle.
    ticks: VecDeque<(u64, u64)>,
    /// Gaps in which nothing was received: time of the last cycle before, and of the first one after, µs.
    gaps: VecDeque<(u64, u64)>,
    /// Whether the next cycle ends a gap.
    interrupted: bool,
}

/// Largest number of gaps.
const MAX_GAPS: usize = 1000;

const UNKNOWN: ComponentNow = ComponentNow { state: free(false, None), since_us: 0 };

/// Returns the state of a component that is not held and has no rate.
pub(crate) const fn free(active: bool, state: Option<u16>) -> ComponentState {
    ComponentState { active, held: Hold::Tree, state, hz: None }
}

impl States {
    pub(crate) fn new(components: usize) -> Self {
        let (base, current) = (vec![UNKNOWN; components], vec![UNKNOWN; components]);
        let (changes, ticks, gaps) = (VecDeque::new(), VecDeque::new(), VecDeque::new());
        Self { base, changes, current, ticks, gaps, interrupted: false }
    }

    /// Begins a gap, which ends with the next cycle that is added.
    pub(super) const fn interrupt(&mut self) {
        self.interrupted = true;
    }

    /// Returns whether the next cycle ends a gap.
    pub(crate) const fn is_interrupted(&self) -> bool {
        self.interrupted
    }

    /// Returns the gaps in which nothing was received, µs, the oldest first.
    pub(crate) fn gaps(&self) -> impl Iterator<Item = &(u64, u64)> {
        self.gaps.iter()
    }

    /// Adds a cycle with the states of all components. Returns the changes.
    pub(crate) fn push(
        &mut self,
        time_us: u64,
        cycle: u64,
        components: impl Iterator<Item = ComponentState>,
    ) -> Vec<Change> {
        let is_first = self.ticks.is_empty();
        let before = self.last().filter(|(last, _)| *last < time_us);
        if let Some((last, _)) = before.filter(|_| std::mem::take(&mut self.interrupted)) {
            self.gaps.push_back((last, time_us));
            if self.gaps.len() > MAX_GAPS {
                self.gaps.pop_front();
            }
        }
        self.ticks.push_back((time_us, cycle));
        let mut changed = Vec::new();
        for (component, state) in components.enumerate().take(self.current.len()) {
            let last = self.current[component];
            let visible = is_first || (state.active, state.state) != last.activity();
            if !visible && state == last.state {
                continue;
            }
            let now = ComponentNow { state, since_us: if visible { time_us } else { last.since_us } };
            self.current[component] = now;
            changed.push(Change { time_us, component: component as u16, visible, now });
        }
        if is_first {
            self.base.clone_from(&self.current);
            return Vec::new();
        }
        self.changes.extend(changed.iter().copied());
        changed
    }

    /// Returns the number of cycles and of changes in memory.
    pub(crate) fn sizes(&self) -> (usize, usize) {
        (self.ticks.len(), self.changes.len())
    }

    /// State after the last cycle.
    pub(crate) fn current(&self) -> &[ComponentNow] {
        &self.current
    }

    /// Time and number of the last cycle.
    pub(crate) fn last(&self) -> Option<(u64, u64)> {
        self.ticks.back().copied()
    }

    pub(super) fn span(&self) -> (u64, u64) {
        let time = |tick: Option<&(u64, u64)>| tick.map_or(0, |(time, _)| *time);
        (time(self.ticks.front()), time(self.ticks.back()))
    }

    /// Returns time, number and states of the last cycle that is not later; before the first cycle those of the first one.
    pub(crate) fn at(&self, time_us: u64) -> Option<(u64, u64, Vec<ComponentNow>)> {
        let end = self.ticks.partition_point(|(time, _)| *time <= time_us);
        let &(time, cycle) = self.ticks.get(end.saturating_sub(1))?;
        let mut states = self.base.clone();
        for change in self.changes.iter().take_while(|change| change.time_us <= time) {
            states[usize::from(change.component)] = change.now;
        }
        Some((time, cycle, states))
    }

    /// Returns time and number of at most `count` cycles after a time and up to another one. The times increase.
    pub(super) fn ticks_after(&self, after_us: Option<u64>, until_us: u64, count: usize) -> Vec<(u64, u64)> {
        let begin = after_us.map_or(0, |after| self.ticks.partition_point(|(time, _)| *time <= after));
        let mut last = after_us;
        // A robot may send times that do not increase.
        let later = |tick: &&(u64, u64)| last.is_none_or(|last| tick.0 > last) && last.replace(tick.0) != Some(tick.0);
        self.ticks.range(begin..).take_while(|tick| tick.0 <= until_us).filter(later).take(count).copied().collect()
    }

    pub(crate) fn base(&self) -> &[ComponentNow] {
        &self.base
    }

    pub(crate) fn changes(&self) -> impl Iterator<Item = &Change> {
        self.changes.iter()
    }

    pub(super) fn evict(&mut self, horizon: u64) {
        while self.ticks.len() > 1 && self.ticks.front().is_some_and(|(time, _)| *time < horizon) {
            self.ticks.pop_front();
        }
        let first = self.span().0;
        while self.gaps.front().is_some_and(|(_, end)| *end <= first) {
            self.gaps.pop_front();
        }
        while self.changes.front().is_some_and(|change| change.time_us <= first) {
            if let Some(change) = self.changes.pop_front() {
                self.base[usize::from(change.component)] = change.now;
            }
        }
    }
}
