//! What the rules require of jobs.

use bica::JobEnd;

use super::event::Event;
use super::graph::{Comparison, Model};
use super::unit::{BEGIN, bit, compute, mix};

/// Job of a component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Job {
    #[default]
    None,
    /// Begun in this cycle, with the value that it computes from.
    Begun(u64),
    /// The same, and its due time.
    Running(u64, u64),
    /// Its result.
    Ready(u64),
}

impl Model {
    /// A job that is due ends before any component is visited.
    pub(super) fn end_jobs(&mut self) -> Comparison {
        for index in 0..self.components.len() {
            if let Job::Running(value, due) = self.components[index].job
                && self.now >= due
            {
                self.expect(&Event::WorkEnded(index, JobEnd::OnTime))?;
                self.components[index].job = Job::Ready(compute(value));
            }
        }
        Ok(())
    }

    /// A job that was begun in this cycle is due a declared time later.
    pub(super) fn begin_jobs(&mut self) -> Comparison {
        for index in 0..self.components.len() {
            if let (Job::Begun(value), Some(work)) = (self.components[index].job, self.graph.nodes[index].work) {
                let due = self.now.saturating_add(u64::from(work.takes_ms) * 1000);
                self.components[index].job = Job::Running(value, due);
                self.expect(&Event::WorkBegun(index, due))?;
            }
        }
        Ok(())
    }

    /// Compares what a component with work found in its run, and begins a job in place of another one if its flags say so.
    pub(super) fn worked(&mut self, index: usize, found: (Option<u64>, bool)) -> Comparison {
        let data = &mut self.components[index];
        let result = if let Job::Ready(result) = data.job { Some(result) } else { None };
        if result.is_some() {
            data.job = Job::None;
        }
        let expected = (result, data.job == Job::None);
        data.value = result.map_or(data.value, |result| mix(data.value, result));
        if data.flags & bit(BEGIN) != 0 {
            data.job = Job::Begun(data.value);
        }
        if found == expected { Ok(()) } else { Err(format!("{found:?} instead of {expected:?}")) }
    }
}
