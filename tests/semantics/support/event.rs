//! The events of a tree, in one list for the probe and for the components.

use std::cell::RefCell;

use bica::prelude::*;

/// A component as it was read: its name and its value.
pub(crate) type Read = (&'static str, u64);

/// The times that a component was given, in clock ticks: now, since its last run, in its state.
pub(crate) type Times = (u64, u64, u64);

/// Something that happened. Numbers are indices of components and states, names are those of the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    CycleBegin(u64),
    CycleEnd,
    Start(usize),
    Stop(usize),
    Skip(usize),
    Run(usize),
    Begin(usize),
    End(usize),
    Transition(usize, usize, usize),
    /// The start hook of a component.
    Started(&'static str),
    /// The stop hook of a component.
    Stopped(&'static str),
    /// A transition was evaluated.
    Asked {
        by: &'static str,
        transition: &'static str,
        reads: Vec<Read>,
    },
    /// An entry or exit hook.
    Hook {
        of: &'static str,
        hook: &'static str,
        reads: Vec<Read>,
        writes: Vec<&'static str>,
    },
    /// The code of a step or of a state.
    Body {
        of: &'static str,
        state: &'static str,
        time: Times,
        reads: Vec<Read>,
        writes: Vec<&'static str>,
    },
    /// A component set the rate of another, in bits: NaN is to be equal to itself.
    Rated {
        of: &'static str,
        hz: u32,
    },
}

thread_local! {
    static EVENTS: RefCell<Vec<Event>> = const { RefCell::new(Vec::new()) };
}

/// Records an event.
pub(crate) fn note(event: Event) {
    EVENTS.with_borrow_mut(|events| events.push(event));
}

/// Takes the events recorded since the last call.
pub(crate) fn taken() -> Vec<Event> {
    EVENTS.take()
}

/// Records all events of a probe.
pub(crate) struct Recorder;

impl Probe for Recorder {
    fn cycle_begin(&mut self, now: Instant) {
        note(Event::CycleBegin(now.as_ticks()));
    }

    fn cycle_end(&mut self) {
        note(Event::CycleEnd);
    }

    fn start(&mut self, component: ComponentId) {
        note(Event::Start(component.index()));
    }

    fn stop(&mut self, component: ComponentId) {
        note(Event::Stop(component.index()));
    }

    fn skip(&mut self, component: ComponentId) {
        note(Event::Skip(component.index()));
    }

    fn run(&mut self, component: ComponentId) {
        note(Event::Run(component.index()));
    }

    fn begin(&mut self, component: ComponentId) {
        note(Event::Begin(component.index()));
    }

    fn end(&mut self, component: ComponentId) {
        note(Event::End(component.index()));
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        note(Event::Transition(component.index(), from, to));
    }
}
