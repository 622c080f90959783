//! Breakpoints of live sessions.

use bica_link::Error;
use bica_wire::message::WorldChange;

use super::attached::Attached;

impl Attached<'_> {
    /// Sends which breakpoints were reached. A world of this process has paused at the cycle itself. One behind a link is paused
    /// now, some cycles later; a robot is never stopped.
    pub(super) fn stop_at_breakpoints(&mut self) -> Result<(), Error> {
        let own = self.session.pacer.as_ref().map(|pacer| pacer.news()).unwrap_or_default();
        for (time_us, taken) in own.taken {
            self.session.shared().history.taken.push(time_us, taken);
        }
        for &reached in &own.reached {
            self.session.hit(reached, true);
        }
        let reached = std::mem::take(&mut self.reached);
        if reached.is_empty() {
            return Ok(());
        }
        let paused = self.session.shared().can.pause && self.pause_at_breakpoint()?;
        for reached in reached {
            self.session.hit(reached, paused);
        }
        Ok(())
    }

    /// Pauses a world behind the link; returns whether it did.
    fn pause_at_breakpoint(&mut self) -> Result<bool, Error> {
        match self.request_pace(WorldChange::Pause) {
            Ok(()) => Ok(true),
            Err(Error::Disconnected(reason)) => Err(Error::Disconnected(reason)),
            // Another monitor operates the world.
            Err(_) => Ok(false),
        }
    }
}
