//! Queue of requests.

use std::collections::VecDeque;
use std::vec::Vec;

use bica_core::Instant;
use bica_core::params::{Setting, Value};
use bica_core::refusal::Refusal;

use crate::request::{Change, Request, Requests};

/// Request that owns its values.
pub type OwnedRequest = Change<Vec<Setting>, Vec<Value>>;

impl From<Request<'_>> for OwnedRequest {
    fn from(request: Request<'_>) -> Self {
        match request {
            Request::Hold { component, hold } => Self::Hold { component, hold },
            Request::Rate { component, hz } => Self::Rate { component, hz },
            Request::Params(settings) => Self::Params(settings.to_vec()),
            Request::Modulate { component, modulation, arguments } => {
                Self::Modulate { component, modulation, arguments: arguments.to_vec() }
            }
            Request::World { action, arguments } => Self::World { action, arguments: arguments.to_vec() },
            Request::Go { component, state } => Self::Go { component, state },
        }
    }
}

/// Queue of requests; all are applied before the next cycle, in their order.
#[derive(Clone, Debug, Default)]
pub struct RequestQueue {
    waiting: VecDeque<OwnedRequest>,
    /// The request that is being applied.
    current: Option<OwnedRequest>,
    answers: Vec<Result<(), Refusal>>,
}

impl RequestQueue {
    /// Creates an empty queue.
    #[must_use]
    pub const fn new() -> Self {
        Self { waiting: VecDeque::new(), current: None, answers: Vec::new() }
    }

    /// Appends a request.
    pub fn push(&mut self, request: impl Into<OwnedRequest>) {
        self.waiting.push_back(request.into());
    }

    /// Removes and returns the results of all requests that were applied or refused since the last call, in the order of
    /// the requests.
    pub fn take_answers(&mut self) -> Vec<Result<(), Refusal>> {
        core::mem::take(&mut self.answers)
    }
}

impl Requests for RequestQueue {
    fn next(&mut self, _now: Instant) -> Option<Request<'_>> {
        self.current = self.waiting.pop_front();
        self.current.as_ref().map(OwnedRequest::borrow)
    }

    fn answered(&mut self, _now: Instant, result: Result<(), Refusal>) {
        self.answers.push(result);
    }
}
