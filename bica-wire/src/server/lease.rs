//! The lease, and the changes requested under it.

use core::time::Duration;

use bica_core::graph::Graph;
use bica_core::{Hold, Instant};

use super::component_set::ComponentSet;
use crate::message::{Change, LeaseAction, LeaseState, RefusalCode, Request};

/// Owner of the lease.
#[derive(Clone, Copy, Debug)]
struct Owner {
    /// None after the connection has ended.
    connection: Option<u64>,
    /// Time of its last request or action on the lease.
    heard: Duration,
}

/// The lease of a tree, and the changes requested under it.
///
/// A server calls [`act`](Self::act) for each action of a monitor and [`check_silence`](Self::check_silence) before each cycle.
/// It applies the changes of [`next_ending`](Self::next_ending) before any request of a monitor. It passes each change that
/// [`admit`](Self::admit) and the tree have accepted to [`record`](Self::record).
///
/// A *stop* of the tree needs no lease. It ends the lease, and with it all holds and changed rates.
///
/// Times are those of the clock by which the server measures silence; it must not run backwards.
#[derive(Clone, Debug)]
pub struct Lease {
    number: u64,
    owner: Option<Owner>,
    silence: Duration,
    holds: ComponentSet,
    rates: ComponentSet,
    /// Components whose hold ends.
    ending_holds: ComponentSet,
    /// Components whose changed rate ends.
    ending_rates: ComponentSet,
}

impl Lease {
    /// Creates a lease without an owner. It ends after a `silence` of its owner.
    #[must_use]
    pub const fn new(silence: Duration) -> Self {
        Self {
            number: 0,
            owner: None,
            silence,
            holds: ComponentSet::EMPTY,
            rates: ComponentSet::EMPTY,
            ending_holds: ComponentSet::EMPTY,
            ending_rates: ComponentSet::EMPTY,
        }
    }

    /// Performs an action of a connection; returns whether the lease changed. `random` becomes the number of a new lease. The
    /// number proves the ownership of the lease, so it must be secret.
    pub fn act(&mut self, connection: u64, action: LeaseAction, now: Duration, random: u64) -> bool {
        match action {
            LeaseAction::Acquire if self.is_foreign(connection) => false,
            LeaseAction::Acquire if self.owner.is_some() => {
                self.own(connection, now);
                false
            }
            LeaseAction::Acquire | LeaseAction::Take => {
                let random = random.max(1);
                self.number = if random == self.number { random.wrapping_add(1).max(1) } else { random };
                self.own(connection, now);
                true
            }
            LeaseAction::Keep { lease } if lease == self.number => {
                let Some(owner) = self.owner.filter(|owner| owner.connection.is_none_or(|owner| owner == connection))
                else {
                    return false;
                };
                self.own(connection, now);
                owner.connection.is_none()
            }
            LeaseAction::Return { lease } if lease == self.number && self.owns(connection) => {
                self.end();
                true
            }
            LeaseAction::Keep { .. } | LeaseAction::Return { .. } => false,
        }
    }

    const fn own(&mut self, connection: u64, heard: Duration) {
        self.owner = Some(Owner { connection: Some(connection), heard });
    }

    fn is_foreign(&self, connection: u64) -> bool {
        self.owner.is_some() && !self.owns(connection)
    }

    fn owns(&self, connection: u64) -> bool {
        self.owner.is_some_and(|owner| owner.connection == Some(connection))
    }

    /// Handles the end of a connection. If it owned the lease, another one continues it with [`LeaseAction::Keep`] and its
    /// number, until the silence ends it.
    pub fn disconnect(&mut self, connection: u64) {
        if let Some(owner) = self.owner.as_mut().filter(|owner| owner.connection == Some(connection)) {
            owner.connection = None;
        }
    }

    /// Checks whether a request of a connection to a tree may be applied in the cycle at `instant`. A stop is always admitted,
    /// any other request only from the owner of the lease. A request of the owner also ends its silence, expired or not.
    ///
    /// # Errors
    /// [`RefusalCode::NoLease`], [`RefusalCode::Expired`].
    pub fn admit(
        &mut self,
        connection: u64,
        request: &Request,
        graph: &Graph,
        now: Duration,
        instant: Instant,
    ) -> Result<(), RefusalCode> {
        if request.change.is_stop(graph) {
            return Ok(());
        }
        self.admit_lease(connection, (request.lease, request.expires_us), now, instant)
    }

    /// Checks as [`admit`](Self::admit) whether a request with the number of a lease and an expiry, µs, may be performed.
    ///
    /// # Errors
    /// [`RefusalCode::NoLease`], [`RefusalCode::Expired`].
    #[inline]
    pub fn admit_lease(
        &mut self,
        connection: u64,
        (lease, expires_us): (u64, u64),
        now: Duration,
        instant: Instant,
    ) -> Result<(), RefusalCode> {
        if lease != self.number || !self.owns(connection) {
            return Err(RefusalCode::NoLease);
        }
        self.own(connection, now);
        if instant.as_micros() > expires_us { Err(RefusalCode::Expired) } else { Ok(()) }
    }

    /// Ends the lease if its owner was silent for too long; returns whether it did.
    pub fn check_silence(&mut self, now: Duration) -> bool {
        let silent = self.owner.is_some_and(|owner| now.saturating_sub(owner.heard) > self.silence);
        if silent {
            self.end();
        }
        silent
    }

    fn end(&mut self) {
        self.owner = None;
        self.ending_holds.take_all(&mut self.holds);
        self.ending_rates.take_all(&mut self.rates);
    }

    /// Records a change that was applied to a tree, for the end of the lease. Returns whether it was a stop that ended a lease.
    pub fn record(&mut self, change: &Change, graph: &Graph) -> bool {
        match change {
            stop if stop.is_stop(graph) => {
                let owned = self.owner.is_some();
                self.end();
                return owned;
            }
            Change::Hold { component, hold } => self.holds.set(*component, *hold != Hold::Tree),
            Change::Rate { component, hz } => self.rates.set(*component, hz.is_some()),
            Change::Params(_) | Change::Modulate { .. } | Change::World { .. } | Change::Go { .. } => {}
        }
        false
    }

    /// Takes the next change that ends a hold or a rate of an ended lease: holds first, each in the order of the tree's list.
    pub fn next_ending(&mut self) -> Option<Change> {
        let hold = self.ending_holds.pop().map(|component| Change::Hold { component, hold: Hold::Tree });
        hold.or_else(|| self.ending_rates.pop().map(|component| Change::Rate { component, hz: None }))
    }

    /// Returns the state of the lease for a connection; only the owner gets the number.
    #[must_use]
    pub fn state(&self, connection: u64, now: Instant) -> LeaseState {
        let yours = self.owns(connection);
        LeaseState {
            lease: if yours { self.number } else { 0 },
            owned: self.owner.is_some(),
            yours,
            time_us: now.as_micros(),
        }
    }
}
