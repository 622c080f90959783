//! What a session remembers.

mod images;
mod info;
mod part;
mod states;
mod timeline;

use std::collections::VecDeque;

use crate::protocol::{LogLine, Truth};

pub(super) use images::{Images, StoredImage};
pub(super) use info::InfoStore;
pub(super) use states::{Change, States};

/// Largest number of log lines.
const MAX_LINES: usize = 20_000;
/// Largest number of stored true states.
const MAX_TRUTHS: usize = 100_000;

/// Limits of what is remembered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Time, µs; none for a recording, which is remembered whole.
    pub(super) ring_us: Option<u64>,
    /// Memory of information, bytes.
    pub(super) info_bytes: usize,
    /// Memory of images, bytes.
    pub(super) image_bytes: usize,
}

/// What a session remembers: the last minutes of a robot, or a recording.
#[derive(Debug)]
pub(super) struct History {
    limits: Limits,
    pub(super) states: States,
    pub(super) info: InfoStore,
    pub(super) images: Images,
    lines: VecDeque<LogLine>,
    truths: VecDeque<(u64, Truth)>,
    /// Times at which a run of a component took longer than its budget.
    overruns: VecDeque<(u64, u16)>,
    /// Transitions that were taken: time, µs, component and index. In a session behind a link only those with breakpoints.
    taken: VecDeque<(u64, usize, usize)>,
}

impl History {
    pub(super) fn new(limits: Limits, components: usize) -> Self {
        Self {
            limits,
            states: States::new(components),
            info: InfoStore::default(),
            images: Images::new(limits.image_bytes),
            lines: VecDeque::new(),
            truths: VecDeque::new(),
            overruns: VecDeque::new(),
            taken: VecDeque::new(),
        }
    }

    /// First and last time of which the state is known, µs.
    pub(super) fn span(&self) -> (u64, u64) {
        self.states.span()
    }

    /// What follows is not received until the next cycle that is added.
    pub(super) fn interrupt(&mut self) {
        self.states.interrupt();
        self.info.interrupt();
    }

    /// Memory of information and images, bytes.
    pub(super) const fn bytes(&self) -> usize {
        self.info.bytes() + self.images.bytes()
    }

    pub(super) fn add_line(&mut self, line: LogLine) {
        if self.lines.len() >= MAX_LINES {
            self.lines.pop_front();
        }
        // Lines of this server may bear a time that is a little older than the last one of the robot.
        let place = self.lines.iter().rev().take_while(|other| other.time_us > line.time_us).count();
        self.lines.insert(self.lines.len() - place, line);
    }

    pub(super) fn add_truth(&mut self, time_us: u64, truth: Truth) {
        if self.truths.len() >= MAX_TRUTHS {
            self.truths.pop_front();
        }
        self.truths.push_back((time_us, truth));
    }

    pub(super) fn add_overrun(&mut self, time_us: u64, component: u16) {
        if self.overruns.len() >= MAX_TRUTHS {
            self.overruns.pop_front();
        }
        // A link reports the overruns of all components of a window at its end, not in their order.
        let place = self.overruns.iter().rev().take_while(|(other, _)| *other > time_us).count();
        self.overruns.insert(self.overruns.len() - place, (time_us, component));
    }

    pub(super) fn add_taken(&mut self, time_us: u64, component: usize, transition: usize) {
        if self.taken.len() >= MAX_TRUTHS {
            self.taken.pop_front();
        }
        self.taken.push_back((time_us, component, transition));
    }

    /// Transitions that were taken, the oldest first.
    pub(super) fn taken(&self) -> impl Iterator<Item = &(u64, usize, usize)> {
        self.taken.iter()
    }

    /// Returns the last lines of an interval, oldest first.
    pub(super) fn lines(&self, from_us: u64, until_us: u64, limit: usize) -> Vec<LogLine> {
        let end = self.lines.partition_point(|line| line.time_us <= until_us);
        let begin = self.lines.partition_point(|line| line.time_us < from_us).min(end);
        self.lines.range(begin.max(end.saturating_sub(limit))..end).cloned().collect()
    }

    /// Returns the last true state that is not later.
    pub(super) fn truth(&self, time_us: u64) -> Option<&Truth> {
        let end = self.truths.partition_point(|(time, _)| *time <= time_us);
        self.truths.get(end.checked_sub(1)?).map(|(_, truth)| truth)
    }

    /// Times of overruns of a component in an interval, at most one for each `resolution_us`.
    pub(super) fn overruns(&self, component: usize, from_us: u64, until_us: u64, resolution_us: u64) -> Vec<u64> {
        let begin = self.overruns.partition_point(|(time, _)| *time < from_us);
        let mut times: Vec<u64> = Vec::new();
        for &(time, of) in self.overruns.range(begin..) {
            if time > until_us {
                break;
            }
            let is_apart = times.last().is_none_or(|last| time - last >= resolution_us);
            if usize::from(of) == component && is_apart {
                times.push(time);
            }
        }
        times
    }

    /// Forgets what is older than the ring, or does not fit into the memory.
    pub(super) fn evict(&mut self) {
        let (first, last) = self.span();
        if let Some(ring) = self.limits.ring_us {
            let horizon = last.saturating_sub(ring);
            self.states.evict(horizon);
            self.info.evict(horizon);
            self.images.evict(horizon);
            while self.lines.front().is_some_and(|line| line.time_us < horizon) {
                self.lines.pop_front();
            }
            while self.truths.front().is_some_and(|(time, _)| *time < horizon) {
                self.truths.pop_front();
            }
            while self.overruns.front().is_some_and(|(time, _)| *time < horizon) {
                self.overruns.pop_front();
            }
            while self.taken.front().is_some_and(|(time, ..)| *time < horizon) {
                self.taken.pop_front();
            }
        }
        let mut horizon = first;
        while self.info.bytes() > self.limits.info_bytes && horizon < last {
            horizon += ((last - first) / 8).max(1);
            self.info.evict(horizon);
        }
    }
}
