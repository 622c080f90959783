//! Stops of monitors, and the transitions that they watch.

use std::collections::{BTreeMap, BTreeSet};

use bica::{ComponentId, Instant, Tree};
use bica_wire::message::{Reached, Stop, StopAt, Taken, WorldChange};

use super::conditions::ConditionTable;
use super::control::Control;
use super::outbox::Message;
use super::watcher::MAX_WATCHED;

/// Whether a component is active, and its state.
type Activity = (bool, Option<u16>);

/// Stops of monitors, and the transitions that they watch.
#[derive(Debug, Default)]
pub(super) struct Stops {
    set: BTreeMap<u64, BTreeSet<Stop>>,
    /// Connections that watch transitions.
    taken: BTreeSet<u64>,
    /// States of all components after the last cycle and after the one before.
    now: Vec<Activity>,
    before: Vec<Activity>,
}

impl Stops {
    /// Sets or removes a stop; returns whether there was room.
    pub(super) fn set(&mut self, connection: u64, stop: Stop, is_set: bool) -> bool {
        let stops = self.set.entry(connection).or_default();
        if !is_set {
            stops.remove(&stop);
            return true;
        }
        let room = stops.len() < MAX_WATCHED || stops.contains(&stop);
        if room {
            stops.insert(stop);
        }
        room
    }

    pub(super) fn watch_taken(&mut self, connection: u64, is_watched: bool) {
        if is_watched {
            self.taken.insert(connection);
        } else {
            self.taken.remove(&connection);
        }
    }

    /// Forgets a monitor that is disconnected.
    pub(super) fn forget(&mut self, connection: u64) {
        self.set.remove(&connection);
        self.taken.remove(&connection);
    }

    /// Takes in the states after a cycle.
    fn read<T: Tree>(&mut self, tree: &T) {
        std::mem::swap(&mut self.now, &mut self.before);
        let status = |index| tree.status(ComponentId::new(index));
        let activity = |index| status(index).map(|now| (now.active, now.state.map(|state| state as u16)));
        self.now.clear();
        self.now.extend((0..T::COUNT).map(|index| activity(index).unwrap_or_default()));
    }

    fn is_reached(&self, stop: Stop, conditions: &ConditionTable) -> bool {
        let component = usize::from(stop.component);
        match stop.at {
            StopAt::State(state) => {
                let now = Some(&(true, Some(state)));
                self.now.get(component) == now && self.before.get(component) != now
            }
            StopAt::Transition(transition) => conditions.taken(component) == Some(transition.into()),
        }
    }
}

impl Control {
    /// Reports transitions and stops of this cycle to the monitors that watch them, and pauses the world at a stop.
    pub(super) fn look_at_stops<T: Tree>(&mut self, now: Instant, tree: &T, conditions: &ConditionTable) {
        self.stops.read(tree);
        let time_us = now.as_micros();
        let mut messages = Vec::new();
        if !self.stops.taken.is_empty() {
            for component in 0..T::COUNT {
                let Some(transition) = conditions.taken(component) else { continue };
                let (component, transition) = (component as u16, transition as u16);
                let taken = Message::Taken(Taken { time_us, component, transition });
                messages.extend(self.stops.taken.iter().map(|&connection| (connection, taken.clone())));
            }
        }
        let mut pauses = false;
        for (&connection, stops) in &self.stops.set {
            let lease = self.lease.state(connection, now);
            let may_pause = self.can_pause() && !self.watch_only && (lease.yours || !lease.owned);
            for &stop in stops.iter().filter(|stop| self.stops.is_reached(**stop, conditions)) {
                let paused = stop.pauses && may_pause;
                pauses |= paused;
                messages.push((connection, Message::Reached(Reached { time_us, stop, paused })));
            }
        }
        for (connection, message) in messages {
            self.tell(connection, message);
        }
        if pauses {
            self.pace.change(WorldChange::Pause);
            self.announce_world();
        }
    }
}
