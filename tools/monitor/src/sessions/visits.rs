//! Visits of a machine's states in a session's history.

use std::iter::Peekable;

use bica_vicode::coverage::Visits;

use super::session::Session;
use super::value::unknown;
use crate::protocol::ComponentNow;
use crate::protocol::Failed;

/// Excludes the gaps before a time, in which nothing was received.
fn pass<'a>(
    visits: &mut Visits,
    gaps: &mut Peekable<impl Iterator<Item = &'a (u64, u64)>>,
    end: u64,
    now: Option<&str>,
) {
    while let Some((from, until)) = gaps.next_if(|gap| gap.1 <= end) {
        visits.sample(*from, None);
        if *until < end {
            visits.sample(*until, now);
        }
    }
}

impl Session {
    /// Returns the states of a component over the time in memory.
    pub(super) fn visits(&self, component: usize) -> Result<Visits, Failed> {
        let description = self.description()?;
        let name = |state: Option<u16>| description.state(component, state.map(usize::from));
        let mut visits = Visits::default();
        let shared = self.shared();
        let states = &shared.history.states;
        let base = states.base().get(component).ok_or_else(|| unknown("component", component))?;
        let (first, last) = shared.history.span();
        let own = states.changes().filter(|change| change.visible && usize::from(change.component) == component);
        let mut gaps = states.gaps().peekable();
        let named = |now: &ComponentNow| now.state.active.then(|| name(now.state.state)).flatten();
        let mut now = named(base);
        visits.begin();
        visits.sample(first, now);
        for change in own {
            pass(&mut visits, &mut gaps, change.time_us, now);
            now = named(&change.now);
            visits.sample(change.time_us, now);
        }
        pass(&mut visits, &mut gaps, last, now);
        visits.sample(last, now);
        Ok(visits)
    }
}
