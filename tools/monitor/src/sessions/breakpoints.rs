//! Breakpoints of a session.

use super::breakpoint_target::{BreakpointTarget, moved, next};
use super::commands::Command;
use super::session::Session;
use super::shared::Shared;
use crate::protocol::{Breakpoint, Failed, Hit, Reached, ToPage};
use bica_wire::message::{LogLine, LogSource};

/// Largest number of breakpoints of a session.
const MAX_BREAKPOINTS: usize = 500;

impl Session {
    /// Replaces all breakpoints, and sends them to all pages.
    pub(super) fn set_breakpoints(&self, list: &[Breakpoint]) -> Result<(), Failed> {
        if list.len() > MAX_BREAKPOINTS {
            let what = format!("{} breakpoints, at most {MAX_BREAKPOINTS} are possible", list.len());
            return Err(Failed::new(what, "remove some"));
        }
        let description = self.description()?;
        let is_exact = self.shared().can.conditions;
        let found = list.iter().map(|one| BreakpointTarget::find(*one, &description, is_exact));
        let targets = found.collect::<Result<Vec<_>, _>>()?;
        {
            let mut shared = self.shared();
            shared.breakpoints = targets;
            self.pages.broadcast(&self.breakpoints(&shared));
        }
        // The thread sets the stops at the robot; a recording has no thread.
        let _ = self.command(Command::Watch);
        Ok(())
    }

    /// Takes over the breakpoints of the session that this one replaces, as far as its tree has the same states and transitions.
    pub(super) fn inherit(&self, other: &Self) {
        let (tree, targets) = {
            let other = other.shared();
            (other.description.clone(), other.breakpoints.clone())
        };
        let Some(tree) = tree else { return };
        let mut shared = self.shared();
        if let Some(now) = shared.description.clone() {
            let targets = moved(&targets, &tree, &now, shared.can.conditions);
            drop(shared);
            let list: Vec<_> = targets.iter().map(|target| target.breakpoint).collect();
            // They are valid in this tree.
            let _ = self.set_breakpoints(&list);
        } else {
            shared.inherited = Some((tree, targets));
        }
    }

    /// Returns the message with the breakpoints, for pages.
    pub(super) fn breakpoints(&self, shared: &Shared) -> ToPage {
        let list = shared.breakpoints.iter().map(|target| target.breakpoint).collect();
        ToPage::Breakpoints { session: self.id, list }
    }

    /// Finds the first time in memory after `from_us`, µs, at which a breakpoint is reached.
    pub(super) fn next_hit(&self, from_us: u64) -> Option<Reached> {
        let shared = self.shared();
        next(&shared.history, &shared.breakpoints, from_us, shared.can.conditions)
    }

    /// Logs that a breakpoint was reached, and sends it to all pages.
    pub(super) fn hit(&self, reached: Reached, paused: bool) {
        let text = {
            let shared = self.shared();
            let target = shared.breakpoints.iter().find(|target| target.breakpoint == reached.breakpoint);
            target.map_or_else(String::new, |target| target.text.clone())
        };
        let end = if paused { ": the world is paused" } else { "" };
        let text = format!("breakpoint: {text}{end}");
        self.add_line(LogLine { time_us: reached.time_us, level: 2, source: LogSource::Monitor, text });
        self.pages.broadcast(&ToPage::Hit(Hit { session: self.id, reached, paused }));
    }
}
