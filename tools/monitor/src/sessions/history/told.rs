//! Entries of the log.

use bica_link::{Description, happened};
use bica_recording::{RecordedCycle, RequestRecord, RunEvent};
use bica_wire::message::{LogLine, LogSource};

/// An entry of the log, with its exact content. The line of text is derived from it.
#[derive(Clone, Debug)]
pub(in crate::sessions) enum Told {
    /// A line of text.
    Line(LogLine<String>),
    /// A request was applied.
    Request(RequestRecord),
    /// Something happened in the world.
    Event(RunEvent),
}

impl Told {
    /// Returns the line for people, with the names of the tree.
    pub(in crate::sessions) fn line(&self, time_us: u64, tree: &Description) -> LogLine<String> {
        let (source, text) = match self {
            Self::Line(line) => return line.clone(),
            Self::Request(request) => (LogSource::Operator, request.describe(tree)),
            Self::Event(RunEvent { kind, detail, .. }) => (LogSource::World, happened(kind, detail)),
        };
        LogLine { time_us, level: 2, source, text }
    }

    /// Adds the entry to a cycle of a recording.
    pub(in crate::sessions) fn record(self, cycle: &mut RecordedCycle) {
        match self {
            Self::Line(LogLine { level, source, text, .. }) => {
                cycle.log.push(bica_recording::LogLine { level, source, text });
            }
            Self::Request(request) => cycle.requests.push(request),
            Self::Event(event) => cycle.events.push(event),
        }
    }

    /// Returns the log entries of a recorded cycle at a time, µs.
    pub(in crate::sessions) fn of_cycle(cycle: RecordedCycle, time_us: u64) -> impl Iterator<Item = Self> {
        let line =
            move |bica_recording::LogLine { level, source, text }| Self::Line(LogLine { time_us, level, source, text });
        let requests = cycle.requests.into_iter().map(Self::Request);
        requests.chain(cycle.events.into_iter().map(Self::Event)).chain(cycle.log.into_iter().map(line))
    }
}
