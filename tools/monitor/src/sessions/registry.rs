//! All sessions.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use super::common::Common;
use super::session::Session;
use super::world::Setup;
use super::{folder, live, recorded};
use crate::options::Options;
use crate::pages::{PageId, lock};
use crate::program::Program;
use crate::protocol::{Failed, LIMITS, Open, SessionId, SessionInfo, ToPage};
use crate::source::Host;

/// Largest number of sessions.
const MAX_SESSIONS: usize = LIMITS.sessions;

/// Longest wait until a recorded file is closed.
const END: Duration = Duration::from_secs(10);

/// All sessions.
pub(super) struct Registry {
    pub(super) common: Common,
    sessions: Mutex<BTreeMap<SessionId, Arc<Session>>>,
    last: AtomicU32,
}

impl Registry {
    pub(super) fn new(options: Options, program: Program) -> Self {
        let common = Common { options: Arc::new(options), program: Arc::new(program), pages: Arc::default() };
        Self { common, sessions: Mutex::default(), last: AtomicU32::new(0) }
    }

    /// Returns a number that no session has had.
    pub(super) fn next_id(&self) -> SessionId {
        self.last.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Opens a session. A new thread connects it, or reads it. A world or a robot is recorded in a file, if one is given.
    pub(super) fn open(&self, source: Open, record: Option<PathBuf>) -> Result<SessionId, Failed> {
        self.has_room()?;
        let id = self.next_id();
        let session = match source {
            Open::World { world, seed, options } => {
                let setup = Setup { world, seed, options, tuned: BTreeMap::new() };
                live::open_world(id, &self.common, setup, record)?
            }
            Open::Robot { address } => live::open_robot(id, &self.common, &address, record)?,
            Open::Images {} => folder::open(id, &self.common)?,
            Open::Recording { name } => recorded::open(id, &self.common, &name)?,
        };
        self.add(&session)?;
        Ok(id)
    }

    fn has_room(&self) -> Result<(), Failed> {
        let has_room = lock(&self.sessions).len() < MAX_SESSIONS;
        let full = || Failed::new(format!("{MAX_SESSIONS} sessions are open"), "close one of them");
        has_room.then_some(()).ok_or_else(full)
    }

    pub(super) fn add(&self, session: &Arc<Session>) -> Result<(), Failed> {
        if let Err(failed) = self.has_room() {
            session.end();
            return Err(failed);
        }
        lock(&self.sessions).insert(session.id, Arc::clone(session));
        session.announce();
        Ok(())
    }

    /// Returns all sessions as a page sees them.
    pub(super) fn infos(&self, page: PageId) -> Vec<SessionInfo> {
        lock(&self.sessions).values().map(|session| session.info(page)).collect()
    }

    pub(super) fn list(&self) -> Vec<Arc<Session>> {
        lock(&self.sessions).values().cloned().collect()
    }

    pub(super) fn get(&self, id: SessionId) -> Result<Arc<Session>, Failed> {
        let none = || Failed::new(format!("there is no session {id}"), "it was closed: choose another one");
        lock(&self.sessions).get(&id).cloned().ok_or_else(none)
    }

    pub(super) fn close(&self, id: SessionId) -> Result<(), Failed> {
        let session = self.get(id)?;
        lock(&self.sessions).remove(&id);
        session.end();
        self.common.pages.broadcast(&ToPage::Closed { session: id });
        Ok(())
    }

    /// Ends all sessions.
    pub(super) fn end(&self) {
        let sessions = std::mem::take(&mut *lock(&self.sessions));
        for session in sessions.values() {
            session.end();
        }
        for session in sessions.values() {
            session.wait_for_file(END);
        }
    }
}

impl Host for Registry {
    fn open(&self, address: &str, replaced: Option<SessionId>) -> Result<SessionId, Failed> {
        let replaced = replaced.and_then(|session| self.get(session).ok());
        if let Some(session) = &replaced {
            Host::close(self, session.id);
        }
        let id = self.open(Open::Robot { address: address.to_owned() }, None)?;
        if let Some((before, now)) = replaced.zip(self.get(id).ok()) {
            now.inherit(&before);
        }
        Ok(id)
    }

    fn close(&self, session: SessionId) {
        // A page may have closed it.
        let _ = self.close(session);
    }
}
