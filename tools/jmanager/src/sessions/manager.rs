//! All sessions and all pages.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use serde_json::{Value, json};

use super::live;
use super::options::Options;
use super::outbox::Outbox;
use super::pages::{PageId, Pages, lock};
use super::session::Session;
use super::{colours, folder, recorded, storage, tune};
use crate::protocol::{Failed, FromPage, LogKind, Open, Request, SessionId, SessionInfo, SessionKind, ToPage, VERSION};

/// Largest number of sessions.
const MAX_SESSIONS: usize = 16;
/// Longest note, characters.
const MAX_NOTE: usize = 500;

/// All sessions. Pages attach to it; what they ask for is answered through their outboxes.
pub struct Manager {
    options: Arc<Options>,
    pages: Arc<Pages>,
    sessions: Mutex<BTreeMap<SessionId, Arc<Session>>>,
    /// Held while layouts are written.
    layouts: Mutex<()>,
    last_session: AtomicU32,
    last_page: AtomicU64,
}

impl Manager {
    /// A manager without sessions.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self {
            options: Arc::new(options),
            pages: Arc::default(),
            sessions: Mutex::default(),
            layouts: Mutex::default(),
            last_session: AtomicU32::new(0),
            last_page: AtomicU64::new(0),
        }
    }

    /// Opens a session. It is connected, or read, by a thread of its own.
    ///
    /// # Errors
    /// If the source is unknown or there are too many sessions.
    pub fn open(&self, source: Open) -> Result<SessionId, Failed> {
        self.has_room()?;
        let id = self.last_session.fetch_add(1, Ordering::Relaxed) + 1;
        let session = match source {
            Open::World { world, seed, robots } => {
                live::open_world(id, &self.options, &self.pages, (&world, seed, robots))?
            }
            Open::Robot { address } => live::open_robot(id, &self.options, &self.pages, &address)?,
            Open::Images {} => folder::open(id, &self.options, &self.pages)?,
            Open::Recording { name } => recorded::open(id, &self.options, &self.pages, &name)?,
        };
        self.add(&session)?;
        Ok(id)
    }

    fn has_room(&self) -> Result<(), Failed> {
        let has_room = lock(&self.sessions).len() < MAX_SESSIONS;
        let full = || Failed::new(format!("{MAX_SESSIONS} sessions are open"), "close one of them");
        has_room.then_some(()).ok_or_else(full)
    }

    fn add(&self, session: &Arc<Session>) -> Result<(), Failed> {
        if let Err(failed) = self.has_room() {
            session.end();
            return Err(failed);
        }
        lock(&self.sessions).insert(session.id, Arc::clone(session));
        session.announce();
        Ok(())
    }

    /// Returns all sessions as a page sees them.
    fn infos(&self, page: PageId) -> Vec<SessionInfo> {
        lock(&self.sessions).values().map(|session| session.info(page)).collect()
    }

    /// Registers a page. The first message in its outbox is [`ToPage::Hello`].
    pub fn attach(&self, outbox: Arc<dyn Outbox>) -> PageId {
        let page = self.last_page.fetch_add(1, Ordering::Relaxed) + 1;
        outbox.state(ToPage::Hello {
            protocol: VERSION,
            program: env!("CARGO_PKG_VERSION"),
            page,
            read_only: self.options.read_only,
            source: self.options.source.is_some(),
            build: false,
            sessions: self.infos(page),
        });
        self.pages.add(page, outbox);
        // A session that changed between the two lines above is sent again.
        let sessions: Vec<_> = lock(&self.sessions).values().cloned().collect();
        for session in sessions {
            self.pages.state(page, ToPage::Session { session: session.info(page) });
            session.send_description(page);
        }
        page
    }

    /// Forgets a page. What it operated ends.
    pub fn detach(&self, page: PageId) {
        self.pages.remove(page);
        for session in lock(&self.sessions).values() {
            session.shared().watches.remove(&page);
            // A thread that has ended operates nothing.
            let _ = session.command(live::Command::Left(page));
        }
    }

    /// Handles a message of a page. The answer comes through its outbox, at once or later.
    pub fn handle(&self, page: PageId, message: FromPage) {
        let FromPage { id, request } = message;
        match self.answer(page, id, request) {
            Ok(Some(value)) => self.pages.answer(page, id, Ok(value)),
            Ok(None) => {}
            Err(failed) => self.pages.answer(page, id, Err(failed)),
        }
    }

    fn session(&self, id: SessionId) -> Result<Arc<Session>, Failed> {
        let none = || Failed::new(format!("there is no session {id}"), "it was closed: choose another one");
        lock(&self.sessions).get(&id).cloned().ok_or_else(none)
    }

    /// Returns the answer; none if it follows later.
    fn answer(&self, page: PageId, id: u32, request: Request) -> Result<Option<Value>, Failed> {
        match request {
            Request::Open { source } => return self.open(source).map(|session| Some(json!({ "session": session }))),
            Request::Close { session } => return self.close(session).map(|()| Some(Value::Null)),
            Request::Recordings {} => return Ok(Some(storage::recordings(&self.options))),
            Request::Layouts {} => return storage::layouts(&self.options).map(Some),
            Request::Source { .. } => {
                return Err(Failed::new("this server has no folder of sources", "start it with --source FOLDER"));
            }
            Request::SaveLayout { name, layout } => {
                let _one_at_a_time = lock(&self.layouts);
                return storage::save_layout(&self.options, &name, layout).map(|()| Some(Value::Null));
            }
            _ => {}
        }
        let session =
            self.session(request.session().ok_or_else(|| {
                Failed::new("this request is not known yet", "reload the page, or update the program")
            })?)?;
        match request {
            Request::At { .. } | Request::Timeline { .. } | Request::Series { .. } | Request::Lines { .. } => {
                session.query(page, id, &request).map(Some)
            }
            Request::Watch { watch, .. } => {
                session.shared().watches.insert(page, watch);
                // A recording has no thread that needs to know.
                let _ = session.command(live::Command::Watch);
                Ok(Some(Value::Null))
            }
            Request::Note { text, .. } => {
                if text.chars().count() > MAX_NOTE {
                    return Err(Failed::new("the note is too long", format!("write at most {MAX_NOTE} characters")));
                }
                if let Some(pacer) = &session.pacer {
                    pacer.note(&text);
                }
                session.log(2, LogKind::Note, text);
                Ok(Some(Value::Null))
            }
            Request::Pause { .. } | Request::Resume { .. } | Request::Step { .. } => {
                self.writable()?;
                pace(&session, page, id, request)
            }
            Request::Colours { .. }
            | Request::Boundary { .. }
            | Request::Classify { .. }
            | Request::ScoreColours { .. } => colours::handle(&session, page, id, &request),
            Request::PickColours { .. }
            | Request::UndoColours { .. }
            | Request::LoadColours { .. }
            | Request::SendColours { .. }
            | Request::SaveColours { .. } => {
                self.writable()?;
                colours::handle(&session, page, id, &request)
            }
            Request::SaveSource { .. } => {
                let help = "save it to a tune file, or write the new default into the source by hand";
                Err(Failed::new("this program cannot write sources", help))
            }
            Request::Compare { other, .. } => {
                recorded::compare(page, id, &session, &*self.session(other)?).map(|()| None)
            }
            Request::RunAgain { settings, .. } => {
                self.writable()?;
                let id = self.last_session.fetch_add(1, Ordering::Relaxed) + 1;
                let again = recorded::run_again(id, &session, &settings)?;
                self.add(&again)?;
                Ok(Some(json!({ "session": id })))
            }
            Request::KeepRecording { name, .. } => {
                self.writable()?;
                storage::keep(&session, page, id, &name).map(|()| None)
            }
            Request::SaveTune { params, name, .. } => {
                self.writable()?;
                tune::save(&session, &params, &name).map(Some)
            }
            _ if session.kind == SessionKind::Recording => {
                let help = "open a robot or a world; a recording can be run again with other parameters";
                Err(Failed::new("a recording cannot be operated", help))
            }
            request => {
                self.writable()?;
                session.command(live::Command::Operate { page, id, request }).map(|()| None)
            }
        }
    }

    fn writable(&self) -> Result<(), Failed> {
        let failed = || Failed::new("this server lets pages only watch", "start it without --read-only");
        if self.options.read_only { Err(failed()) } else { Ok(()) }
    }

    fn close(&self, id: SessionId) -> Result<(), Failed> {
        self.writable()?;
        let session = self.session(id)?;
        lock(&self.sessions).remove(&id);
        session.end();
        self.pages.broadcast(&ToPage::Closed { session: id });
        Ok(())
    }
}

impl Drop for Manager {
    fn drop(&mut self) {
        let sessions = std::mem::take(&mut *lock(&self.sessions));
        for session in sessions.values() {
            session.end();
        }
        // Threads that still end leave a file there; the folder is one for temporary files.
        let _ = std::fs::remove_dir(&self.options.spool);
    }
}

/// Pauses or continues a world; returns the answer, none if it follows later.
fn pace(session: &Session, page: PageId, id: u32, request: Request) -> Result<Option<Value>, Failed> {
    let Some(pacer) = &session.pacer else {
        if session.kind == SessionKind::Recording {
            return Err(Failed::new("a recording has no time that could be paused", "choose a simulated world"));
        }
        return session.command(live::Command::Operate { page, id, request }).map(|()| None);
    };
    match request {
        Request::Pause { .. } => pacer.pause(),
        Request::Step { cycles, .. } => pacer.step(cycles),
        _ => pacer.resume(),
    }
    session.announce();
    Ok(Some(Value::Null))
}
