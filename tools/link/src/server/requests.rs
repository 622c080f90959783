//! The source of requests in the loop.

use std::sync::atomic::Ordering;
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use bica::runner::{Request, Requests};
use bica::{Instant, Refusal};
use bica_wire::message::{Change, RefusalCode, Stop, WorldChange};

use super::control::{Applied, Control};
use super::hub::{Command, Inbound};

/// Largest number of messages that are handled before one cycle, besides those that only watch.
const MESSAGES_PER_CYCLE: usize = 64;
/// Largest number of messages that only watch and are handled before one cycle.
const WATCHES_PER_CYCLE: usize = 64;

/// Source of requests in the loop. It never waits.
#[derive(Debug)]
pub struct LinkRequests {
    inbox: Receiver<Inbound>,
    /// Messages that only watch: a request does not wait for the hundreds that a monitor may send.
    watches: Receiver<Inbound>,
    /// Stops: they wait for nothing else.
    stops: Receiver<Inbound>,
    control: Arc<Mutex<Control>>,
    /// Number of messages that may still be handled before this cycle.
    budget: usize,
    current: Option<Current>,
}

/// The request that the last call of `next` returned.
#[derive(Debug)]
enum Current {
    /// A request of the server itself, at the end of a lease.
    Ending(Box<Change>),
    Operator(Box<Applied>),
}

impl LinkRequests {
    pub(super) fn new(inboxes: [Receiver<Inbound>; 3], control: Arc<Mutex<Control>>) -> Self {
        let [inbox, watches, stops] = inboxes;
        Self { inbox, watches, stops, control, budget: MESSAGES_PER_CYCLE, current: None }
    }

    /// Returns whether the next cycle of a simulated world may run. While the operator has paused it, the loop calls
    /// [`Runner::apply_requests`](bica::runner::Runner::apply_requests) at intervals instead.
    pub fn begins_cycle(&mut self) -> bool {
        lock(&self.control).pace.begins_cycle()
    }

    /// Pauses the world on behalf of its program, because its run is over.
    pub fn pause(&mut self) {
        let mut control = lock(&self.control);
        control.pace.change(WorldChange::Pause);
        control.announce_world();
        control.hand_over();
    }

    /// Sets breakpoints of the program: the world pauses after a cycle that reaches one, whoever owns the lease, and a line of the
    /// log says which. Only a world that can be paused reaches them.
    pub fn break_at(&mut self, stops: Vec<Stop>) {
        lock(&self.control).stops.set_own(stops);
    }

    /// Returns the next request and handles all messages before it.
    fn take(&mut self, now: Instant) -> Option<Current> {
        let mut control = lock(&self.control);
        control.check_silence(now);
        if self.budget == MESSAGES_PER_CYCLE {
            for message in self.watches.try_iter().take(WATCHES_PER_CYCLE) {
                message.from.pending.fetch_sub(1, Ordering::Relaxed);
                control.handle(now, message);
            }
        }
        loop {
            if let Some(ending) = control.lease.next_ending() {
                return Some(Current::Ending(Box::new(ending)));
            }
            self.budget = self.budget.checked_sub(1)?;
            let message = self.stops.try_recv().or_else(|_| self.inbox.try_recv()).ok()?;
            if !matches!(message.command, Command::Open) {
                message.from.pending.fetch_sub(1, Ordering::Relaxed);
            }
            if let Some(request) = control.handle(now, message) {
                return Some(Current::Operator(Box::new(request)));
            }
        }
    }
}

pub(super) fn lock(control: &Mutex<Control>) -> MutexGuard<'_, Control> {
    control.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Requests for LinkRequests {
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        self.current = self.take(now);
        let Some(current) = &self.current else {
            self.budget = MESSAGES_PER_CYCLE;
            return None;
        };
        Some(match current {
            Current::Ending(change) => change.borrow(),
            Current::Operator(applied) => applied.change.borrow(),
        })
    }

    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        let mut control = lock(&self.control);
        let applied = match self.current.take() {
            Some(Current::Operator(applied)) => applied,
            Some(Current::Ending(change)) => return control.announce_change(now, &change),
            None => return,
        };
        match result {
            Ok(()) => {
                let graph = control.hub.graph;
                let ended = control.lease.record(&applied.change, graph);
                if let Change::Params(batch) = &applied.change {
                    control.changed.extend(batch.iter().map(|setting| setting.component.index() as u16));
                }
                if let Change::World { .. } = applied.change {
                    control.watchers.owe_truth();
                }
                control.announce_change(now, &applied.change);
                control.applied.push(*applied);
                if ended {
                    control.announce_lease(now);
                    control.log(now, 3, "the stop has ended control: holds and rates end");
                }
            }
            Err(refusal) => {
                let (entry, reason) = (refusal.entry as u16, refusal.to_string());
                let text = control.hub.description.named(applied.change.borrow());
                let text = format!("{text} refused: {reason}");
                control.log(now, 3, &text);
                let Applied { connection, number, arrived, .. } = *applied;
                let is_of_world = matches!(applied.change, Change::World { .. });
                let code = if is_of_world { RefusalCode::World } else { RefusalCode::Tree };
                control.refuse(connection, number, arrived, code, entry, reason);
            }
        }
    }
}
