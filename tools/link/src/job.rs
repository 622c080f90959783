//! What happened to a job beside the loop, as an event.

use bica::JobEnd;

/// Kind of the events of jobs.
pub const JOB: &str = "work";

/// What happened to a job. Its event has the kind [`JOB`], and says it in words that can be read back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JobEvent {
    /// It was begun, and is due after this time, ms.
    Begun(u64),
    /// It has ended.
    Ended(JobEnd),
}

impl JobEvent {
    /// Returns the detail of its event; `name` is that of the component and its function: `Planner.search has begun, due in 20 ms`.
    #[must_use]
    pub fn detail(self, name: &str) -> String {
        match self {
            Self::Begun(ms) => format!("{name} has begun, due in {ms} ms"),
            Self::Ended(end) => format!("{name} {}", end.text()),
        }
    }

    /// Reads an event: the name of the component and its function, and what happened; `None` if it is none of a job.
    #[must_use]
    pub fn read<'a>(kind: &str, detail: &'a str) -> Option<(&'a str, Self)> {
        let (name, what) = detail.split_once(" has ").filter(|_| kind == JOB)?;
        let ends = [JobEnd::OnTime, JobEnd::Late, JobEnd::Failed].map(Self::Ended);
        let due = what.strip_prefix("begun, due in ").and_then(|rest| rest.strip_suffix(" ms")?.parse().ok());
        let event = due.map(Self::Begun).or_else(|| ends.into_iter().find(|end| end.detail(name) == detail))?;
        Some((name, event))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_of_jobs_are_read_as_written() {
        let ends = [JobEnd::OnTime, JobEnd::Late, JobEnd::Failed].map(JobEvent::Ended);
        for event in [JobEvent::Begun(20)].into_iter().chain(ends) {
            let detail = event.detail("Leg<0>.search");
            assert_eq!(JobEvent::read(JOB, &detail), Some(("Leg<0>.search", event)));
            assert_eq!(JobEvent::read("goal", &detail), None);
        }
        assert_eq!(JobEvent::read(JOB, "Planner.search has begun, due in x ms"), None);
    }
}
