//! The lease, and what was requested under it.

use std::collections::{BTreeSet, VecDeque};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use bica::runner::Request;
use bica::{ComponentId, Hold, Instant};
use bica_wire::message::{LeaseAction, LeaseState};

/// Owner of the lease.
#[derive(Clone, Copy, Debug)]
struct Owner {
    connection: u64,
    /// When it was heard last.
    heard: Duration,
}

/// The lease, and what was requested under it.
#[derive(Debug)]
pub(super) struct Lease {
    number: u32,
    owner: Option<Owner>,
    silence: Duration,
    holds: BTreeSet<u16>,
    rates: BTreeSet<u16>,
    endings: VecDeque<Ending>,
}

/// Request of the server itself, at the end of a lease.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    Hold(u16),
    Rate(u16),
}

impl Ending {
    /// Returns the request that gives the component back to the tree.
    pub(super) fn request(self) -> Request<'static> {
        let id = |component: u16| ComponentId::new(component.into());
        match self {
            Self::Hold(component) => Request::Hold { component: id(component), hold: Hold::Tree },
            Self::Rate(component) => Request::Rate { component: id(component), hz: f32::NAN },
        }
    }
}

impl Lease {
    pub(super) fn new(silence: Duration) -> Self {
        // Numbers of an earlier run of the program must not be valid in this one.
        let number = SystemTime::now().duration_since(UNIX_EPOCH).map_or(1, |since| since.as_secs() as u32);
        Self::starting_at(silence, number)
    }

    const fn starting_at(silence: Duration, number: u32) -> Self {
        Self { number, owner: None, silence, holds: BTreeSet::new(), rates: BTreeSet::new(), endings: VecDeque::new() }
    }

    /// Performs an action of a connection; returns whether the lease changed.
    pub(super) fn act(&mut self, connection: u64, action: LeaseAction, now: Duration) -> bool {
        match action {
            LeaseAction::Acquire if self.is_foreign(connection) => false,
            LeaseAction::Acquire if self.owner.is_some() => {
                self.own(connection, now);
                false
            }
            LeaseAction::Acquire | LeaseAction::Take => {
                self.number = self.number.wrapping_add(1).max(1);
                self.own(connection, now);
                true
            }
            LeaseAction::Keep { lease } if lease == self.number && self.owner.is_some() => {
                let moved = self.is_foreign(connection);
                self.own(connection, now);
                moved
            }
            LeaseAction::Return { lease } if lease == self.number && self.owns(connection) => {
                self.end();
                true
            }
            LeaseAction::Keep { .. } | LeaseAction::Return { .. } => false,
        }
    }

    const fn own(&mut self, connection: u64, heard: Duration) {
        self.owner = Some(Owner { connection, heard });
    }

    fn is_foreign(&self, connection: u64) -> bool {
        self.owner.is_some_and(|owner| owner.connection != connection)
    }

    fn owns(&self, connection: u64) -> bool {
        self.owner.is_some_and(|owner| owner.connection == connection)
    }

    /// Whether a request of a connection with this number is valid. It also ends the operator's silence.
    pub(super) fn admits(&mut self, connection: u64, lease: u32, now: Duration) -> bool {
        let valid = lease == self.number && self.owns(connection);
        if valid {
            self.own(connection, now);
        }
        valid
    }

    /// Ends the lease if its owner was silent for too long; returns whether it did.
    pub(super) fn check_silence(&mut self, now: Duration) -> bool {
        let silent = self.owner.is_some_and(|owner| now.saturating_sub(owner.heard) > self.silence);
        if silent {
            self.end();
        }
        silent
    }

    fn end(&mut self) {
        self.owner = None;
        self.endings.extend(std::mem::take(&mut self.holds).into_iter().map(Ending::Hold));
        self.endings.extend(std::mem::take(&mut self.rates).into_iter().map(Ending::Rate));
    }

    /// Records that a hold was applied.
    pub(super) fn held(&mut self, component: u16, is_held: bool) {
        if is_held {
            self.holds.insert(component);
        } else {
            self.holds.remove(&component);
        }
    }

    /// Records that a rate was applied.
    pub(super) fn rated(&mut self, component: u16, is_changed: bool) {
        if is_changed {
            self.rates.insert(component);
        } else {
            self.rates.remove(&component);
        }
    }

    /// Takes the next request that ends what was requested under a lease.
    pub(super) fn next_ending(&mut self) -> Option<Ending> {
        self.endings.pop_front()
    }

    /// Returns the lease as a connection may see it: only the owner learns the number.
    pub(super) fn state(&self, connection: u64, now: Instant) -> LeaseState {
        let yours = self.owns(connection);
        LeaseState {
            lease: if yours { self.number } else { 0 },
            owned: self.owner.is_some(),
            yours,
            time_us: now.as_micros(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn one_connection_owns_the_lease_until_another_takes_it() {
        let mut lease = Lease::starting_at(ms(3000), 7);
        assert!(lease.act(1, LeaseAction::Acquire, ms(0)));
        let at = Instant::from_micros(5);
        assert_eq!(lease.state(1, at), LeaseState { lease: 8, owned: true, yours: true, time_us: 5 });
        assert_eq!(lease.state(2, at), LeaseState { lease: 0, owned: true, yours: false, time_us: 5 });
        assert!(!lease.act(2, LeaseAction::Acquire, ms(0)));
        assert!(lease.admits(1, 8, ms(0)) && !lease.admits(2, 8, ms(0)) && !lease.admits(1, 7, ms(0)));
        assert!(lease.act(2, LeaseAction::Take, ms(0)));
        assert!(lease.admits(2, 9, ms(0)) && !lease.admits(1, 8, ms(0)) && !lease.admits(1, 9, ms(0)));
        assert!(
            !lease.act(1, LeaseAction::Return { lease: 8 }, ms(0))
                && !lease.act(1, LeaseAction::Return { lease: 9 }, ms(0))
        );
        assert!(lease.act(2, LeaseAction::Return { lease: 9 }, ms(0)));
        assert_eq!(lease.state(2, Instant::MIN), LeaseState::default());
    }

    #[test]
    fn silence_ends_the_lease_and_what_was_requested_under_it() {
        let mut lease = Lease::starting_at(ms(3000), 0);
        lease.act(1, LeaseAction::Acquire, ms(1000));
        lease.held(4, true);
        lease.held(5, true);
        lease.held(5, false);
        lease.rated(6, true);
        assert!(!lease.check_silence(ms(4000)));
        lease.act(1, LeaseAction::Keep { lease: 1 }, ms(4000));
        assert!(!lease.check_silence(ms(7000)));
        assert_eq!(lease.next_ending(), None);
        assert!(lease.check_silence(ms(7001)));
        assert_eq!([lease.next_ending(), lease.next_ending()], [Some(Ending::Hold(4)), Some(Ending::Rate(6))]);
        assert_eq!(lease.next_ending(), None);
        assert!(!lease.act(1, LeaseAction::Keep { lease: 1 }, ms(7001)) && !lease.admits(1, 1, ms(7001)));
    }

    #[test]
    fn a_new_connection_of_the_operator_continues_its_lease() {
        let mut lease = Lease::starting_at(ms(3000), 0);
        lease.act(1, LeaseAction::Acquire, ms(0));
        assert!(!lease.admits(2, 1, ms(0)));
        assert!(lease.act(2, LeaseAction::Keep { lease: 1 }, ms(2000)));
        assert!(lease.admits(2, 1, ms(2000)) && !lease.admits(1, 1, ms(2000)));
    }
}
