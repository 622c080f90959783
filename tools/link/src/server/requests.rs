//! The source of requests in the loop.

use std::fmt::Write;
use std::sync::atomic::Ordering;
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use bica::params::{Setting, Value, find};
use bica::runner::{Request, Requests};
use bica::{ComponentId, Graph, Hold, Instant, Refusal};
use bica_wire::message::{Change, RefusalCode};

use super::control::{Applied, Control};
use super::hub::{Command, Inbound};
use super::lease::Ending;

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
    control: Arc<Mutex<Control>>,
    /// Number of messages that may still be handled before this cycle.
    budget: usize,
    current: Option<Current>,
    settings: Vec<Setting>,
    arguments: Vec<Value>,
}

/// The request that the last call of `next` returned.
#[derive(Debug)]
enum Current {
    Ending(Ending),
    Operator(Box<Applied>),
}

impl LinkRequests {
    pub(super) fn new(inboxes: [Receiver<Inbound>; 2], control: Arc<Mutex<Control>>) -> Self {
        let [inbox, watches] = inboxes;
        Self {
            inbox,
            watches,
            control,
            budget: MESSAGES_PER_CYCLE,
            current: None,
            settings: Vec::new(),
            arguments: Vec::new(),
        }
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
                return Some(Current::Ending(ending));
            }
            self.budget = self.budget.checked_sub(1)?;
            let message = self.inbox.try_recv().ok()?;
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
        let change = match current {
            Current::Ending(ending) => return Some(ending.request()),
            Current::Operator(applied) => &applied.change,
        };
        let id = |component: u16| ComponentId::new(component.into());
        Some(match change {
            Change::Hold { component, hold } => Request::Hold { component: id(*component), hold: (*hold).into() },
            Change::Rate { component, hz } => Request::Rate { component: id(*component), hz: *hz },
            Change::Params(batch) => {
                self.settings.clear();
                let setting = |setting: &bica_wire::message::Setting| {
                    Setting::new(id(setting.component), setting.index, setting.value.into())
                };
                self.settings.extend(batch.iter().map(setting));
                Request::Params(&self.settings)
            }
            Change::Modulate { component, modulation, arguments } => {
                self.arguments.clear();
                self.arguments.extend(arguments.iter().map(|&value| Value::from(value)));
                Request::Modulate { component: id(*component), index: (*modulation).into(), arguments: &self.arguments }
            }
        })
    }

    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        let Some(Current::Operator(applied)) = self.current.take() else { return };
        let mut control = lock(&self.control);
        let text = describe(control.hub.graph, &applied.change);
        match result {
            Ok(()) => {
                match &applied.change {
                    Change::Hold { component, hold } => {
                        control.lease.held(*component, Hold::from(*hold) != Hold::Tree);
                    }
                    Change::Rate { component, hz } => control.lease.rated(*component, !hz.is_nan()),
                    Change::Params(batch) => {
                        control.changed.extend(batch.iter().map(|setting| setting.component));
                    }
                    Change::Modulate { .. } => {}
                }
                control.applied.push(*applied);
                control.log(now, 2, &format!("operator: {text}"));
            }
            Err(refusal) => {
                let Applied { connection, number, arrived, .. } = *applied;
                let (entry, reason) = (refusal.entry as u16, refusal.to_string());
                control.log(now, 3, &format!("operator: {text} refused: {reason}"));
                control.refuse(connection, number, arrived, RefusalCode::Tree, entry, reason);
            }
        }
    }
}

/// Returns a line for people.
fn describe(graph: &'static Graph, change: &Change) -> String {
    let node = |component: u16| graph.nodes.get(usize::from(component));
    let name = |component: u16| node(component).map_or("?", |node| node.name);
    match change {
        Change::Hold { component, hold } => format!("hold {} {hold:?}", name(*component)),
        Change::Rate { component, hz } => format!("rate {} {hz} Hz", name(*component)),
        Change::Params(batch) => {
            let mut text = "set".to_owned();
            for setting in batch {
                let param = node(setting.component).and_then(|node| find(node.params, setting.index.into()));
                let (component, param) = (name(setting.component), param.map_or("?", |param| param.name));
                // Writing to a String cannot fail.
                let _ = write!(text, " {component}.{param}={}", Value::from(setting.value));
            }
            text
        }
        Change::Modulate { component, modulation, arguments } => {
            let found = node(*component).and_then(|node| node.modulations.get(usize::from(*modulation)));
            let arguments: Vec<_> = arguments.iter().map(|&value| Value::from(value).to_string()).collect();
            let name = name(*component);
            format!("call {name}.{}({})", found.map_or("?", |found| found.name), arguments.join(", "))
        }
    }
}
