//! Events of a tree. The probe and the components add to the same list.

use std::cell::{Cell, RefCell};

use bica::prelude::*;
use bica::{End, JobEnd};

use crate::semantics::rules;
use crate::semantics::unit::Carried;

/// Read of a component: its name and its value.
pub(crate) type Read = (&'static str, u64);

/// Times passed to a component, clock ticks: now, since its last run, in its state.
pub(crate) type Times = (u64, u64, u64);

/// Event. Numbers are indices of components and states; names are those in the source.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    CycleBegin(u64),
    CycleEnd,
    Framework(rules::Event),
    Begin(usize),
    End(usize),
    /// Result of a condition: component, transition, and whether the condition holds.
    Condition(usize, usize, bool),
    /// Call of the start hook of a component.
    Started(&'static str),
    /// Call of the stop hook of a component.
    Stopped(&'static str),
    /// Evaluation of a transition.
    Evaluated {
        by: &'static str,
        transition: &'static str,
        reads: Vec<Read>,
    },
    /// Call of a hook of a state; an entry hook may take a found value.
    Hook {
        of: &'static str,
        hook: &'static str,
        found: Option<Carried>,
        reads: Vec<Read>,
        writes: Vec<&'static str>,
    },
    /// Run of the code of a step or a state.
    Body {
        of: &'static str,
        state: &'static str,
        time: Times,
        reads: Vec<Read>,
        writes: Vec<&'static str>,
    },
    /// A component with work ran: the result that it took, and whether it has no job.
    Worked {
        of: &'static str,
        result: Option<u64>,
        is_idle: bool,
    },
    /// A job was begun in the cycle: component, due time.
    WorkBegun(usize, u64),
    /// A job has ended.
    WorkEnded(usize, JobEnd),
    /// Result of a child that a condition reads.
    Ended {
        of: &'static str,
        end: Option<End>,
    },
    /// Age of another component, clock ticks.
    Aged {
        of: &'static str,
        since_run: Option<u64>,
    },
    /// Rate that a component set for another one, as bits, so that NaN equals itself.
    RateSet {
        of: &'static str,
        hz: u32,
    },
}

thread_local! {
    static EVENTS: RefCell<Vec<Event>> = const { RefCell::new(Vec::new()) };
    static COUNTS: Cell<(u64, u64)> = const { Cell::new((0, 0)) };
    /// Number of calls of functions of components before one panics.
    static COUNTDOWN: Cell<u32> = const { Cell::new(u32::MAX) };
}

/// Records an event.
pub(crate) fn record(event: Event) {
    EVENTS.with_borrow_mut(|events| events.push(event));
}

/// Records a call of a function of a component, unless it panics.
pub(crate) fn record_call(event: Event) {
    called();
    record(event);
}

/// Counts a call of a function of a component, and panics without a message if it is the one that [`panic_after`] chose.
pub(crate) fn called() {
    let ((calls, panics), left) = (COUNTS.get(), COUNTDOWN.get());
    COUNTS.set((calls + 1, panics + u64::from(left == 0)));
    COUNTDOWN.set(left.saturating_sub(u32::from(left != u32::MAX)));
    if left == 0 {
        COUNTDOWN.set(u32::MAX);
        std::panic::resume_unwind(Box::new("caused by the test"));
    }
}

/// Lets the call after this number of calls panic; none if it is `u32::MAX`.
pub(crate) fn panic_after(calls: u32) {
    COUNTDOWN.set(calls);
}

/// Numbers of calls of functions of components in this thread, and of those that panicked.
pub(crate) fn counts() -> (u64, u64) {
    COUNTS.get()
}

/// Returns the events recorded since the last call.
pub(crate) fn take_events() -> Vec<Event> {
    EVENTS.take()
}

/// Records all events of a probe.
pub(crate) struct Recorder;

impl Probe for Recorder {
    fn cycle_begin(&mut self, now: Instant) {
        record(Event::CycleBegin(now.as_ticks()));
    }

    fn cycle_end(&mut self) {
        record(Event::CycleEnd);
    }

    fn start(&mut self, component: ComponentId) {
        record(Event::Framework(rules::Event::Start(component.index())));
    }

    fn stop(&mut self, component: ComponentId) {
        record(Event::Framework(rules::Event::Stop(component.index())));
    }

    fn skip(&mut self, component: ComponentId) {
        record(Event::Framework(rules::Event::Skip(component.index())));
    }

    fn run(&mut self, component: ComponentId) {
        record(Event::Framework(rules::Event::Run(component.index())));
    }

    fn begin(&mut self, component: ComponentId) {
        record(Event::Begin(component.index()));
    }

    fn end(&mut self, component: ComponentId) {
        record(Event::End(component.index()));
    }

    fn condition(&mut self, component: ComponentId, transition: usize, holds: bool) {
        record(Event::Condition(component.index(), transition, holds));
    }

    fn work_begun(&mut self, component: ComponentId, due: Instant) {
        record(Event::WorkBegun(component.index(), due.as_ticks()));
    }

    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        record(Event::WorkEnded(component.index(), end));
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        record(Event::Framework(rules::Event::Transition(component.index(), from, to)));
    }
}
