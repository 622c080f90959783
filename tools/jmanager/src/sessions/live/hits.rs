//! Breakpoints of live sessions.

use super::attached::Attached;
use crate::protocol::{Breakpoint, Reached};

impl Attached<'_> {
    /// A breakpoint was reached by something that does not stop there by itself. A robot is never stopped.
    pub(super) fn hit(&self, time_us: u64, breakpoint: Breakpoint) {
        self.session.hit(Reached { time_us, breakpoint }, false);
    }

    /// Sends that the world of this process has paused at breakpoints.
    pub(super) fn paused_at_breakpoint(&self) {
        let reached = self.session.pacer.as_ref().map(|pacer| pacer.reached()).unwrap_or_default();
        for &reached in &reached {
            self.session.hit(reached, true);
        }
        if !reached.is_empty() {
            self.session.announce();
        }
    }
}
