//! Queue of requests.

use std::collections::VecDeque;
use std::vec::Vec;

use bica_core::params::{Setting, Value};
use bica_core::refusal::Refusal;
use bica_core::{ComponentId, Hold, Instant};

use crate::request::{Request, Requests};

/// Request that owns its values.
#[derive(Clone, Debug, PartialEq)]
pub enum OwnedRequest {
    /// [`Request::Hold`].
    Hold {
        /// Component.
        component: ComponentId,
        /// Hold from the next tick on.
        hold: Hold,
    },
    /// [`Request::Rate`].
    Rate {
        /// Component.
        component: ComponentId,
        /// Runs per second; `None` is the declared rate.
        hz: Option<f32>,
    },
    /// [`Request::Params`].
    Params(Vec<Setting>),
    /// [`Request::Modulate`].
    Modulate {
        /// Component.
        component: ComponentId,
        /// Index in [`Node::modulations`](bica_core::graph::Node::modulations).
        index: usize,
        /// One value for each argument.
        arguments: Vec<Value>,
    },
}

impl OwnedRequest {
    /// Returns the request with borrowed values.
    #[must_use]
    pub fn borrow(&self) -> Request<'_> {
        match self {
            &Self::Hold { component, hold } => Request::Hold { component, hold },
            &Self::Rate { component, hz } => Request::Rate { component, hz },
            Self::Params(batch) => Request::Params(batch),
            Self::Modulate { component, index, arguments } => {
                Request::Modulate { component: *component, index: *index, arguments }
            }
        }
    }
}

impl From<Request<'_>> for OwnedRequest {
    fn from(request: Request<'_>) -> Self {
        match request {
            Request::Hold { component, hold } => Self::Hold { component, hold },
            Request::Rate { component, hz } => Self::Rate { component, hz },
            Request::Params(batch) => Self::Params(batch.to_vec()),
            Request::Modulate { component, index, arguments } => {
                Self::Modulate { component, index, arguments: arguments.to_vec() }
            }
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
