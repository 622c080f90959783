//! The job of a component, from its begin to its result.

use embassy_time::{Duration, Instant};

use super::{JobEnd, Taken, Working, finish};

/// Progress of the jobs of a component.
pub(super) enum Phase<C: Working> {
    Idle,
    /// Begun in this cycle.
    Begun(C::State),
    /// In its slot until it is due; a cycle runs it then.
    Pending(C::State, Instant),
    /// In its slot, run by the runner in slices; whether a slice is running.
    Sliced(C::State, Instant, bool),
    /// Taken away by the runner.
    Away(Instant),
    /// Ended between two cycles; without a value it panicked.
    Arrived(Option<C::Output>),
    /// The component can take the result.
    Ready(C::Output),
}

/// The jobs of component `C`.
#[doc(hidden)]
pub struct Jobs<C: Working> {
    pub(super) phase: Phase<C>,
    pub(super) ticket: u32,
    /// Whether a cycle at or after the due time began without the result.
    is_late: bool,
}

impl<C: Working> Jobs<C> {
    /// No job.
    #[must_use]
    pub const fn new() -> Self {
        Self { phase: Phase::Idle, ticket: 0, is_late: false }
    }

    /// Begins a job in place of another one.
    pub fn begin(&mut self, state: C::State) {
        self.cancel();
        self.phase = Phase::Begun(state);
    }

    pub(super) fn cancel(&mut self) {
        *self = Self { ticket: self.ticket.wrapping_add(1), ..Self::new() };
    }

    /// Returns the due time of a job that was begun in this cycle.
    pub(super) fn settle(&mut self, now: Instant) -> Option<Instant> {
        if !matches!(self.phase, Phase::Begun(_)) {
            return None;
        }
        let due = now.saturating_add(Duration::from_millis(C::TAKES_MS.into()));
        if let Phase::Begun(state) = core::mem::replace(&mut self.phase, Phase::Idle) {
            self.phase = Phase::Pending(state, due);
        }
        Some(due)
    }

    /// Makes a result that is there available, and that of a job which is due and in its slot; returns how it ended.
    pub(super) fn deliver(&mut self, now: Instant) -> Option<JobEnd> {
        match self.phase {
            Phase::Pending(_, due) if now >= due => {
                let job = self.take()?;
                // If the job unwinds, the component is idle.
                self.phase = Phase::Idle;
                self.phase = Phase::Arrived(Some(finish::<C>(job.state)));
            }
            Phase::Sliced(_, due, _) | Phase::Away(due) => self.is_late |= now >= due,
            _ => {}
        }
        if !matches!(self.phase, Phase::Arrived(_)) {
            return None;
        }
        let Phase::Arrived(output) = core::mem::replace(&mut self.phase, Phase::Idle) else { return None };
        Some(match output {
            None => JobEnd::Failed,
            Some(output) => {
                self.phase = Phase::Ready(output);
                if self.is_late { JobEnd::Late } else { JobEnd::OnTime }
            }
        })
    }

    pub(super) fn take(&mut self) -> Option<Taken<C::State>> {
        let Phase::Pending(_, due) = self.phase else { return None };
        match core::mem::replace(&mut self.phase, Phase::Away(due)) {
            Phase::Pending(state, due) => Some(Taken { ticket: self.ticket, due, state }),
            _ => None,
        }
    }

    pub(super) fn put(&mut self, ticket: u32, output: Option<C::Output>) {
        if self.ticket == ticket && matches!(self.phase, Phase::Away(_)) {
            self.phase = Phase::Arrived(output);
        }
    }

    pub(super) fn claim(&mut self) {
        if let Some(job) = self.take() {
            self.phase = Phase::Sliced(job.state, job.due, false);
        }
    }

    /// Runs a slice of a job; returns whether there was one.
    pub(super) fn slice(&mut self) -> bool {
        let Phase::Sliced(state, _, is_running) = &mut self.phase else { return false };
        // A slice that unwound leaves the mark.
        let output = if core::mem::replace(is_running, true) { Some(None) } else { C::slice(state).map(Some) };
        if let Some(output) = output {
            self.phase = Phase::Arrived(output);
        } else if let Phase::Sliced(_, _, is_running) = &mut self.phase {
            *is_running = false;
        }
        true
    }
}

impl<C: Working> Default for Jobs<C> {
    fn default() -> Self {
        Self::new()
    }
}
