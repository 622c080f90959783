//! Pause, continuation and single cycles of a simulated world.

use std::time::Duration;

use bica_link::Error;
use bica_wire::message::WorldChange;
use serde_json::Value;

use super::attached::Attached;
use crate::pages::PageId;
use crate::protocol::{Failed, Request};
use crate::sessions::shared::Operator;

/// Returns the change of the world that a request contains.
pub(super) const fn world_change(request: &Request) -> Option<WorldChange> {
    match *request {
        Request::Pause { .. } => Some(WorldChange::Pause),
        Request::Resume { .. } => Some(WorldChange::Resume),
        Request::Step { cycles, .. } => Some(WorldChange::Step { cycles }),
        _ => None,
    }
}

impl Attached<'_> {
    /// Changes the world's time for any page. The link requires the lease: if no page owns it, the server acquires it for this one request.
    pub(super) fn pace(&mut self, page: PageId, id: u32, change: WorldChange) -> Result<(), Error> {
        if !self.session.shared().can.pause {
            let help = "only a simulated world can be paused";
            self.session.pages.answer(page, id, Err(Failed::new("time goes on there by itself", help)));
            return Ok(());
        }
        let result = match self.request_pace(change) {
            Ok(()) => Ok(Value::Null),
            Err(Error::Disconnected(reason)) => {
                let failed = Failed::from(Error::Disconnected(reason.clone()));
                self.session.pages.answer(page, id, Err(failed));
                return Err(Error::Disconnected(reason));
            }
            Err(Error::Lease) => {
                Err(Failed::new("another monitor controls the world", "take control, or wait until it gives it back"))
            }
            Err(error) => Err(error.into()),
        };
        self.session.pages.answer(page, id, result);
        Ok(())
    }

    /// Sends the request, and waits for its answer.
    pub(super) fn request_pace(&mut self, change: WorldChange) -> Result<(), Error> {
        let borrows = !matches!(self.session.shared().operator, Operator::Page(_));
        if borrows && self.is_waiting() {
            return Err(Error::Lease);
        }
        if borrows {
            self.client.acquire(false)?;
        }
        let result = self.client.change_world(change).map(drop);
        if borrows {
            self.client.release()?;
            // A page that acquires the lease next must not mistake the borrowed lease for its own.
            while let Some(event) = self.client.poll(Duration::ZERO)? {
                self.event(event)?;
            }
        }
        result
    }

    /// Announces that the world was paused or continued: by itself at a breakpoint or at its end, by a page, or by another operator.
    pub(super) fn look_at_pause(&mut self) -> Result<(), Error> {
        let paused = self.session.is_paused();
        if std::mem::replace(&mut self.is_paused, paused) == paused {
            return Ok(());
        }
        self.look();
        self.session.announce();
        self.watch_extras()
    }
}
