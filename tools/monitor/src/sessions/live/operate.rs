//! The operator of a live session: one page at a time, by the robot's lease.

use std::sync::Arc;
use std::time::{Duration, Instant};

use bica::runner::OwnedRequest;
use bica_link::Answered;
use bica_wire::message::{LeaseAction, LeaseState, LogSource};
use serde_json::{Value, json};

use super::attached::Attached;
use super::operation::{Pending, Waiting, not_connected};
use super::pace::world_change;
use crate::pages::PageId;
use crate::protocol::{Failed, Request};
use crate::sessions::shared::Operator;

/// Silence of the operating page after which its control ends.
const SILENCE: Duration = Duration::from_secs(3);
/// Longest wait for the lease.
const LEASE: Duration = Duration::from_secs(5);
/// Largest number of requests without an answer.
const MAX_PENDING: usize = 64;

type LinkResult = Result<(), bica_link::Error>;

impl Attached<'_> {
    fn operator(&self) -> Operator {
        self.session.shared().operator
    }

    /// Returns whether a page waits for the lease.
    pub(super) const fn is_waiting(&self) -> bool {
        self.operation.waiting.is_some()
    }

    fn set_operator(&self, operator: Operator) {
        let changed = std::mem::replace(&mut self.session.shared().operator, operator) != operator;
        if changed {
            self.session.announce();
        }
    }

    /// Handles a request of a page. A request is never stored to be sent later.
    pub(super) fn operate(&mut self, page: PageId, id: u32, request: Request) -> LinkResult {
        if let Some(change) = world_change(&request) {
            return self.pace(page, id, change);
        }
        if matches!(request, Request::Stop {}) {
            return self.stop(page, id);
        }
        let answer = |result| self.session.pages.answer(page, id, result);
        if !self.session.shared().can.operate {
            answer(Err(Failed::new("this session cannot be operated", "open one that can")));
            return Ok(());
        }
        match request {
            Request::Acquire { .. } => return self.acquire(page, id, false),
            Request::Take { .. } => return self.acquire(page, id, true),
            _ if self.operator() != Operator::Page(page) => {
                let help = "acquire control first; after 3 s of silence, or when somebody takes it, it ends";
                answer(Err(Failed::new("this page does not control the robot", help)));
            }
            Request::Keep { .. } => {
                answer(Ok(Value::Null));
                self.operation.kept = Some(Instant::now());
            }
            Request::Release { .. } => {
                answer(Ok(Value::Null));
                return self.give_back();
            }
            _ if self.operation.pending.len() >= MAX_PENDING => {
                let help = "wait for the answers; a paused world answers when it goes on";
                answer(Err(Failed::new(format!("{MAX_PENDING} requests have no answer yet"), help)));
            }
            Request::Operate { request } => match self.client.description().request(&request) {
                Ok(request) => match self.client.send_request(request.borrow()) {
                    Ok(number) => self.expect_answer(number, Pending { page, id, request }),
                    Err(bica_link::Error::Unknown(invalid)) => answer(Err(invalid.into())),
                    Err(error) => return Err(error),
                },
                Err(invalid) => answer(Err(invalid.into())),
            },
            _ => answer(Err(Failed::new("a live session cannot do this", "choose another session"))),
        }
        Ok(())
    }

    /// Stops the robot, regardless of its operator. The answer to the last of its stops goes to the page.
    fn stop(&mut self, page: PageId, id: u32) -> LinkResult {
        let mut last = None;
        for request in self.client.description().stops().collect::<Vec<_>>() {
            last = Some((self.client.send_request(request.borrow())?, Pending { page, id, request }));
        }
        if let Some((number, pending)) = last {
            self.operation.pending.insert(number, pending);
        } else {
            let failed = Failed::new("this robot declares no stop", "mark a modulation with `#[modulation(stop)]`");
            self.session.pages.answer(page, id, Err(failed));
        }
        Ok(())
    }

    fn expect_answer(&mut self, number: u32, pending: Pending) {
        self.operation.kept = Some(Instant::now());
        self.operation.pending.insert(number, pending);
    }

    fn acquire(&mut self, page: PageId, id: u32, take: bool) -> LinkResult {
        let refuse = |text: &str, help: &str| {
            self.session.pages.answer(page, id, Err(Failed::new(text, help)));
            Ok(())
        };
        match self.operator() {
            Operator::Page(owner) if owner == page => {
                self.operation.kept = Some(Instant::now());
                self.session.pages.answer(page, id, Ok(Value::Null));
                return Ok(());
            }
            Operator::Page(_) if !take => {
                return refuse("another page controls the robot", "wait until it gives control back, or take it");
            }
            _ if self.operation.waiting.is_some() => return refuse("another page asks for control too", "ask again"),
            // The holds of the other page end with its lease.
            Operator::Page(_) => self.client.send_lease(LeaseAction::Return { lease: self.client.lease().lease })?,
            Operator::Nobody | Operator::Other => {}
        }
        let old = self.client.lease().lease;
        self.client.send_lease(if take { LeaseAction::Take } else { LeaseAction::Acquire })?;
        self.operation.waiting = Some(Waiting { page, id, old, since: Instant::now() });
        Ok(())
    }

    /// Restores the control of the page that operated the world before its restart.
    pub(super) fn resume_control(&mut self) -> LinkResult {
        if matches!(self.operator(), Operator::Page(_)) {
            match self.client.acquire(false) {
                Ok(()) => self.operation.kept = Some(Instant::now()),
                Err(bica_link::Error::Lease) => self.set_operator(Operator::Nobody),
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// Handles a message about the owner of the robot's lease.
    pub(super) fn lease(&mut self, lease: LeaseState) -> LinkResult {
        let waiting = self.operation.waiting.take();
        match waiting {
            Some(waiting) if lease.yours && lease.lease != waiting.old => {
                self.operation.kept = Some(Instant::now());
                self.set_operator(Operator::Page(waiting.page));
                self.session.pages.answer(waiting.page, waiting.id, Ok(Value::Null));
            }
            Some(waiting) if lease.owned && !lease.yours => {
                self.set_operator(Operator::Other);
                let help = "wait until it gives control back, or take it";
                let failed = Failed::new("another monitor controls the robot", help);
                self.session.pages.answer(waiting.page, waiting.id, Err(failed));
            }
            Some(waiting) => {
                self.operation.waiting = Some(waiting);
                if !lease.yours {
                    self.set_operator(Operator::Nobody);
                }
            }
            // The message may be older than the current lease, which a page may have acquired again.
            None => return self.lost(self.client.lease()),
        }
        Ok(())
    }

    fn lost(&mut self, lease: LeaseState) -> LinkResult {
        let was = self.operator();
        let now = match was {
            Operator::Page(_) if lease.yours => was,
            _ if lease.owned && !lease.yours => Operator::Other,
            _ => Operator::Nobody,
        };
        if matches!(was, Operator::Page(_)) && now != was {
            self.session.log(3, LogSource::Monitor, "control has ended: holds, rates and modulations end");
        }
        self.set_operator(now);
        // The lease came too late for the page that requested it.
        if now == Operator::Nobody && self.client.lease().yours {
            self.client.send_lease(LeaseAction::Return { lease: self.client.lease().lease })?;
        }
        Ok(())
    }

    /// Ends control of a silent page, and the wait of a page that does not receive the lease.
    pub(super) fn check_operator(&mut self) -> LinkResult {
        if let Some(waiting) = self.operation.waiting.take_if(|waiting| waiting.since.elapsed() > LEASE) {
            let failed = Failed::new("the robot did not answer", "is it paused? Control is given when it goes on");
            self.session.pages.answer(waiting.page, waiting.id, Err(failed));
        }
        let is_silent = self.operation.kept.is_some_and(|kept| kept.elapsed() > SILENCE);
        if is_silent && matches!(self.operator(), Operator::Page(_)) {
            self.session.log(3, LogSource::Monitor, "the page that controlled the robot is silent: control has ended");
            return self.give_back();
        }
        Ok(())
    }

    /// Ends control of a page that was closed.
    pub(super) fn left(&mut self, page: PageId) -> LinkResult {
        if self.operation.waiting.as_ref().is_some_and(|waiting| waiting.page == page) {
            self.operation.waiting = None;
        }
        if self.operator() == Operator::Page(page) {
            self.session.log(3, LogSource::Monitor, "the page that controlled the robot was closed: control has ended");
            return self.give_back();
        }
        Ok(())
    }

    /// Gives the lease back: the holds, rates and modulations that were requested under it end.
    pub(super) fn give_back(&mut self) -> LinkResult {
        self.operation.kept = None;
        if self.client.lease().yours {
            self.client.send_lease(LeaseAction::Return { lease: self.client.lease().lease })?;
        }
        if matches!(self.operator(), Operator::Page(_)) {
            self.set_operator(Operator::Nobody);
        }
        Ok(())
    }

    /// Passes the robot's answer to the page that sent the request.
    pub(super) fn answered(&mut self, answer: Answered) {
        let Some(Pending { page, id, request }) = self.operation.pending.remove(&answer.number) else { return };
        let Answered { cycle, values, refused, .. } = answer;
        let result = if let Some((_, entry, text)) = refused {
            let help = "values must be in their ranges, and requests come from the page in control".to_owned();
            Err(Failed { entry: Some(entry), ..Failed::new(text, help) })
        } else {
            self.remember(&request, &values);
            let values = self.client.description().plain_values(request.borrow(), &values);
            Ok(json!({ "cycle": cycle, "values": values }))
        };
        self.session.pages.answer(page, id, result);
    }

    /// Stores values before the robot reports them, so that a page that reads them after the answer receives the new ones.
    fn remember(&self, request: &OwnedRequest, values: &[bica::Value]) {
        let OwnedRequest::Params(batch) = request else { return };
        let mut shared = self.session.shared();
        let Some(description) = &mut shared.description else { return };
        let components = &mut Arc::make_mut(description).components;
        for (setting, value) in batch.iter().zip(values) {
            let owner = components.get_mut(setting.component.index());
            if let Some(param) = owner.and_then(|owner| owner.params.get_mut(usize::from(setting.index))) {
                param.value = Some(*value);
            }
        }
    }

    /// Refuses the requests that the robot will no longer answer.
    pub(super) fn refuse_pending(&mut self) {
        let operation = std::mem::take(&mut self.operation);
        let waiting = operation.waiting.map(|waiting| (waiting.page, waiting.id));
        let pending = operation.pending.into_values().map(|pending| (pending.page, pending.id));
        for (page, id) in pending.chain(waiting) {
            self.session.pages.answer(page, id, Err(not_connected()));
        }
    }
}
