//! Stops of monitors, and the transitions that they watch.

use bica_wire::message::{Reached, Stop, StopAt, Taken};

use super::conditions::ConditionTable;
use super::outbox::Message;
use super::view::View;
use super::watcher::MAX_WATCHED;

/// Whether a component is active, and its state.
type Activity = (bool, Option<u16>);

/// Stops of monitors, and the transitions that they watch.
#[derive(Debug, Default)]
pub(super) struct Stops {
    /// Each stop with its connection.
    set: Vec<(u64, Stop)>,
    /// Breakpoints of the program.
    own: Vec<Stop>,
    /// Connections that watch transitions.
    taken: Vec<u64>,
    /// States of all components after the last cycle and after the one before.
    now: Vec<Activity>,
    before: Vec<Activity>,
}

impl Stops {
    /// Sets or removes a stop; returns whether there was room.
    pub(super) fn set(&mut self, connection: u64, stop: Stop, is_set: bool) -> bool {
        let count = self.set.iter().filter(|(whose, _)| *whose == connection).count();
        let place = self.set.iter().position(|one| *one == (connection, stop));
        match place {
            Some(place) if !is_set => drop(self.set.remove(place)),
            None if is_set && count >= MAX_WATCHED => return false,
            None if is_set => self.set.push((connection, stop)),
            _ => {}
        }
        true
    }

    /// Sets the breakpoints of the program.
    pub(super) fn set_own(&mut self, stops: Vec<Stop>) {
        self.own = stops;
    }

    /// Returns the reached breakpoints of the program.
    pub(super) fn own_reached(&self, conditions: &ConditionTable) -> Vec<Stop> {
        self.own.iter().copied().filter(|stop| self.is_reached(*stop, conditions)).collect()
    }

    pub(super) fn watch_taken(&mut self, connection: u64, is_watched: bool) {
        self.taken.retain(|one| *one != connection);
        if is_watched {
            self.taken.push(connection);
        }
    }

    /// Removes the stops of a disconnected monitor.
    pub(super) fn forget(&mut self, connection: u64) {
        self.set.retain(|(whose, _)| *whose != connection);
        self.taken.retain(|one| *one != connection);
    }

    /// Stores the states after a cycle.
    pub(super) fn read(&mut self, tree: &impl View) {
        std::mem::swap(&mut self.now, &mut self.before);
        let activity = |index| tree.component_state(index).map(|now| (now.active, now.state));
        self.now.clear();
        self.now.extend((0..tree.graph().nodes.len()).map(|index| activity(index).unwrap_or_default()));
    }

    /// Returns the transitions of the last cycle for the connections that watch them.
    pub(super) fn taken(&self, time_us: u64, conditions: &ConditionTable) -> Vec<(u64, Message)> {
        if self.taken.is_empty() {
            return Vec::new();
        }
        let taken = (0..self.now.len()).filter_map(|component| Some((component, conditions.taken(component)?)));
        let taken = taken.map(|(component, transition)| Taken {
            time_us,
            component: component as u16,
            transition: transition as u16,
        });
        taken.flat_map(|taken| self.taken.iter().map(move |&watching| (watching, Message::Taken(taken)))).collect()
    }

    /// Returns the reached stops, each with its connection, and whether one of them pauses the world. `may_pause` returns whether
    /// a connection may pause it.
    pub(super) fn reached(
        &self,
        time_us: u64,
        conditions: &ConditionTable,
        may_pause: impl Fn(u64) -> bool,
    ) -> (Vec<(u64, Message)>, bool) {
        let (mut messages, mut pauses) = (Vec::new(), false);
        for &(connection, stop) in self.set.iter().filter(|(_, stop)| self.is_reached(*stop, conditions)) {
            let paused = stop.pauses && may_pause(connection);
            pauses |= paused;
            messages.push((connection, Message::Reached(Reached { time_us, stop, paused })));
        }
        (messages, pauses)
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
