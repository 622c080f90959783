//! Pause, single cycles and end of a world.

use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use bica_game::{GameControl, NextStep};

use crate::pages::lock;
use crate::protocol::{Breakpoint, Reached};
use crate::sessions::breakpoints::{Activity, Place};

/// Time between two looks for requests while a world is paused.
const BETWEEN_REQUESTS: Duration = Duration::from_millis(10);

/// Control of a world, shared by its thread and the manager.
#[derive(Debug, Default)]
pub(crate) struct Pacer {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    paused: bool,
    /// Number of cycles to run although it is paused.
    steps: u32,
    end: bool,
    /// Whether the rules have ended the game.
    over: bool,
    /// Notes for the recording.
    notes: Vec<String>,
    /// Why the recording ended.
    not_recorded: Option<String>,
    breakpoints: Vec<Place>,
    /// What happened since the session looked last.
    news: News,
}

/// What happened in a world that its link does not tell.
#[derive(Debug, Default)]
pub(crate) struct News {
    /// Breakpoints that were reached.
    pub(crate) reached: Vec<Reached>,
    /// Transitions that were taken: time, µs, component and index.
    pub(crate) taken: Vec<(u64, (usize, usize))>,
}

impl Pacer {
    /// Begins a new game, which is paused if the last one was paused by a person.
    pub(super) fn begin(&self) {
        let mut state = lock(&self.state);
        let breakpoints = std::mem::take(&mut state.breakpoints);
        *state = State { paused: state.paused && !state.over, breakpoints, ..State::default() };
    }

    pub(crate) fn pause(&self) {
        lock(&self.state).paused = true;
    }

    pub(crate) fn resume(&self) {
        let mut state = lock(&self.state);
        (state.paused, state.steps) = (false, 0);
        self.changed.notify_all();
    }

    /// Pauses, and runs this number of cycles.
    pub(crate) fn step(&self, cycles: u32) {
        let mut state = lock(&self.state);
        state.paused = true;
        state.steps = state.steps.saturating_add(cycles);
        self.changed.notify_all();
    }

    pub(crate) fn end(&self) {
        lock(&self.state).end = true;
        self.changed.notify_all();
    }

    pub(crate) fn is_paused(&self) -> bool {
        lock(&self.state).paused
    }

    pub(crate) fn set_breakpoints(&self, places: Vec<Place>) {
        lock(&self.state).breakpoints = places;
    }

    /// Pauses after this cycle if a breakpoint was reached in it; `before` and `now` are the states of all components, `taken` the
    /// transitions that were taken: component and index.
    pub(super) fn cycle(&self, time_us: u64, before: &[Activity], now: &[Activity], taken: Vec<(usize, usize)>) {
        let mut state = lock(&self.state);
        let reached = |place: &&Place| {
            let component = place.breakpoint.component;
            if let Some(transition) = place.breakpoint.transition {
                return taken.contains(&(component, transition));
            }
            before.get(component).zip(now.get(component)).is_some_and(|(before, now)| place.is_reached(*before, *now))
        };
        let all: Vec<Breakpoint> = state.breakpoints.iter().filter(reached).map(|place| place.breakpoint).collect();
        if !all.is_empty() {
            (state.paused, state.steps) = (true, 0);
            state.news.reached.extend(all.into_iter().map(|breakpoint| Reached { time_us, breakpoint }));
        }
        state.news.taken.extend(taken.into_iter().map(|taken| (time_us, taken)));
    }

    /// What happened since this was called last.
    pub(crate) fn news(&self) -> News {
        std::mem::take(&mut lock(&self.state).news)
    }

    /// Whether the rules have ended the game.
    pub(crate) fn is_over(&self) -> bool {
        lock(&self.state).over
    }

    /// Adds a note to the recording.
    pub(crate) fn note(&self, text: &str) {
        lock(&self.state).notes.push(text.to_owned());
    }

    pub(super) fn not_recorded(&self, reason: &str) {
        lock(&self.state).not_recorded = Some(reason.to_owned());
    }

    /// Why the recording ended before the game.
    pub(crate) fn recording_ended(&self) -> Option<String> {
        lock(&self.state).not_recorded.clone()
    }
}

/// The loop's end of a pacer.
pub(super) struct Control(pub(super) Arc<Pacer>);

impl GameControl for Control {
    fn next(&mut self, is_over: bool) -> NextStep {
        let mut state = lock(&self.0.state);
        if is_over && !state.over {
            (state.over, state.paused, state.steps) = (true, true, 0);
        }
        loop {
            if state.end {
                return NextStep::End;
            }
            if !state.paused {
                return NextStep::Cycle;
            }
            if let Some(left) = state.steps.checked_sub(1) {
                state.steps = left;
                return NextStep::Cycle;
            }
            let waited = self.0.changed.wait_timeout(state, BETWEEN_REQUESTS);
            let timeout;
            (state, timeout) = waited.unwrap_or_else(std::sync::PoisonError::into_inner);
            if timeout.timed_out() {
                return NextStep::Requests;
            }
        }
    }

    /// The link of a world of this server has one monitor, this server.
    fn lets_operators_pause(&self) -> bool {
        false
    }

    fn note(&mut self) -> Option<String> {
        let notes = &mut lock(&self.0.state).notes;
        (!notes.is_empty()).then(|| notes.remove(0))
    }

    fn recording_ended(&mut self, reason: &str) {
        self.0.not_recorded(reason);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transition_breakpoint_ignores_other_transitions_between_the_same_states() {
        let pacer = Pacer::default();
        pacer.set_breakpoints(vec![Place::at(Breakpoint { component: 1, state: None, transition: Some(3) })]);
        let stays = [(true, None), (true, Some(0))];
        for taken in [vec![], vec![(1, 2)], vec![(0, 3)]] {
            pacer.cycle(10, &stays, &stays, taken.clone());
            assert!(!pacer.is_paused() && pacer.news().reached.is_empty(), "{taken:?}");
        }
        pacer.cycle(20, &stays, &stays, vec![(0, 1), (1, 3)]);
        assert!(pacer.is_paused());
        assert_eq!(pacer.news().reached[0].time_us, 20);
    }
}
