//! What the rules require of ticks in which a function of a component panics.

use bica::Status;

use super::event::Event;
use super::graph::{Comparison, Data, Model, NO_EVENT};
use super::jobs::Job;
use super::rules;

impl Model {
    /// Compares the events of a cycle up to the panic of a function.
    pub(crate) fn unwound(&mut self, now: u64, events: Vec<Event>) -> Comparison {
        match self.tick(now, events) {
            Ok(()) => return Err("the cycle is complete".into()),
            Err(difference) if difference == NO_EVENT => {}
            other => return other,
        }
        let is_due = |data: &&mut Data| matches!(data.job, Job::Running(_, due) if now >= due);
        if self.visits {
            self.going = None;
        } else if let Some(data) = self.components.iter_mut().find(is_due) {
            data.job = Job::None;
        }
        Ok(())
    }

    /// Takes over what a component has after a tick that unwound. If it is active, it stops in the next tick, unless a job had panicked.
    pub(crate) fn take_over(&mut self, index: usize, status: &Status, (value, received): (u64, u64)) {
        let (memory, data) = (&mut self.memories[index], &mut self.components[index]);
        memory.end_visit();
        memory.active = status.active;
        memory.interrupted |= self.visits && status.active;
        (data.hz, data.value, data.received, data.found) = (status.hz, value, received, None);
    }

    /// Discards the history of a component that stops because a tick unwound.
    pub(super) fn discard(&mut self, index: usize) -> Comparison {
        self.components[index].started = false;
        self.event(rules::Event::Stop(index))
    }
}
