//! Requests of the operator of a live session.

use std::collections::BTreeMap;
use std::time::Instant;

use bica::runner::OwnedRequest;

use crate::pages::PageId;
use crate::protocol::Failed;

/// A request that the robot has not answered.
pub(super) struct Pending {
    pub(super) page: PageId,
    pub(super) id: u32,
    pub(super) request: OwnedRequest,
}

/// A page that waits for the lease.
pub(super) struct Waiting {
    pub(super) page: PageId,
    pub(super) id: u32,
    /// Number of the lease that the last operator had; 0 for none.
    pub(super) old: u64,
    pub(super) since: Instant,
}

/// Requests of the operator.
#[derive(Default)]
pub(super) struct Operation {
    pub(super) pending: BTreeMap<u32, Pending>,
    pub(super) waiting: Option<Waiting>,
    /// Instant of the last message with which the operating page kept control.
    pub(super) kept: Option<Instant>,
}

pub(super) fn not_connected() -> Failed {
    Failed::new("there is no connection, so the request was not sent", "ask again when the connection is restored")
}
