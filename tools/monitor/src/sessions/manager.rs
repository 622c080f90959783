//! All sessions and all pages.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use serde_json::{Value, json};

use super::asked::Message;
use super::commands;
use super::common::Common;
use super::registry::Registry;
use super::value::unknown;
use super::{recorded, storage, tune};
use crate::options::Options;
use crate::pages::Outbox;
use crate::pages::{PageId, lock};
use crate::program::{Extension, Program, Reply};
use crate::protocol::{Failed, FromPage, LIMITS, Open, Request, SessionId, SessionKind, ToPage, VERSION, World};
use crate::source::{Editor, Host};
use bica_wire::message::LogSource;

/// Owner of all sessions and sources. Pages attach to it, and receive the answers to their requests through their outboxes.
pub struct Manager {
    registry: Arc<Registry>,
    common: Common,
    /// Editor of the sources, or why their folder cannot be opened; none without a folder.
    editor: Option<Result<Editor, Failed>>,
    /// Held while layouts are written.
    layouts: Mutex<()>,
    last_page: AtomicU64,
}

impl Manager {
    /// Creates a manager without sessions.
    #[must_use]
    pub fn new(options: Options, program: Program) -> Self {
        let registry = Arc::new(Registry::new(options, program));
        let common = registry.common.clone();
        let Common { options, pages, .. } = &common;
        let open = |folder: &PathBuf| Editor::new(folder, options, pages, Arc::clone(&registry) as Arc<dyn Host>);
        let editor = options.source.as_ref().map(open);
        Self { registry, common, editor, layouts: Mutex::default(), last_page: AtomicU64::new(0) }
    }

    /// Opens a session. A new thread connects it, or reads it.
    ///
    /// # Errors
    /// If the source is unknown or there are too many sessions.
    pub fn open(&self, source: Open) -> Result<SessionId, Failed> {
        self.registry.open(source, None)
    }

    /// Opens a world or a robot and records it in a file from its beginning. Each later run is recorded in a file with a number.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn open_recorded(&self, source: Open, file: &Path) -> Result<SessionId, Failed> {
        self.registry.open(source, Some(file.to_owned()))
    }

    /// Returns whether the server has a folder of sources. Then no other computer may reach the server.
    #[must_use]
    pub const fn edits_sources(&self) -> bool {
        self.editor.is_some()
    }

    fn worlds(&self) -> Vec<World> {
        let worlds = self.common.program.worlds.iter();
        worlds.map(|world| World { name: world.name().to_owned(), options: world.options() }).collect()
    }

    /// Returns the text of an extension's module.
    pub(crate) fn module(&self, name: &str) -> Option<&str> {
        self.common.program.extension(name).map(Extension::module)
    }

    /// Returns a module that imports all extensions.
    pub(crate) fn modules(&self) -> String {
        let names: Vec<_> = self.common.program.extensions.iter().map(|one| one.name()).collect();
        let imports: Vec<_> =
            names.iter().map(|name| format!("import {name} from './extensions/{name}.js';\n")).collect();
        format!("{}export const EXTENSIONS = [{}];\n", imports.concat(), names.join(", "))
    }

    fn editor(&self) -> Result<&Editor, Failed> {
        let none = || Failed::new("this server has no folder of sources", "start it with --source FOLDER");
        self.editor.as_ref().ok_or_else(none)?.as_ref().map_err(Clone::clone)
    }

    /// Registers a page. The first message in its outbox is [`ToPage::Hello`].
    pub fn attach(&self, outbox: Arc<dyn Outbox>) -> PageId {
        let page = self.last_page.fetch_add(1, Ordering::Relaxed) + 1;
        let sessions = self.registry.infos(page);
        let shown: Vec<_> = sessions.iter().map(|session| session.id).collect();
        outbox.state(ToPage::Hello {
            protocol: VERSION,
            program: env!("CARGO_PKG_VERSION"),
            page,
            read_only: self.common.options.read_only,
            source: self.common.options.source.is_some(),
            build: self.common.options.source.is_some() && self.common.options.build && !self.common.options.read_only,
            worlds: self.worlds(),
            sessions,
            limits: LIMITS,
        });
        self.common.pages.add(page, outbox);
        // Changes before the page was registered are sent again.
        for session in shown.into_iter().filter(|session| self.registry.get(*session).is_err()) {
            self.common.pages.state(page, ToPage::Closed { session });
        }
        for session in self.registry.list() {
            session.greet(page);
        }
        if let Ok(editor) = self.editor() {
            editor.greet(page);
        }
        page
    }

    /// Removes a page. Its control of sessions ends.
    pub fn detach(&self, page: PageId) {
        self.common.pages.remove(page);
        if let Ok(editor) = self.editor() {
            editor.left(page);
        }
        for session in self.registry.list() {
            session.shared().watching.remove(page);
            // A thread that has ended operates nothing.
            let _ = session.command(commands::Command::Left(page));
        }
    }

    /// Handles a message of a page. The answer comes through its outbox, at once or later.
    pub fn handle(&self, page: PageId, message: FromPage) {
        let id = message.id;
        match self.answer(page, message) {
            Ok(Some(value)) => self.common.pages.answer(page, id, Ok(value)),
            Ok(None) => {}
            Err(failed) => self.common.pages.answer(page, id, Err(failed)),
        }
    }

    /// Returns the answer; none if it follows later.
    fn answer(&self, page: PageId, message: FromPage) -> Result<Option<Value>, Failed> {
        let FromPage { id, session, request } = message;
        if self.common.options.read_only && !matches!(request, Request::Stop {}) && !self.only_reads(&request) {
            return Err(read_only());
        }
        match request {
            Request::Open { source } => return self.open(source).map(|session| Some(json!({ "session": session }))),
            Request::Recordings {} => return Ok(Some(storage::recordings(&self.common.options))),
            Request::Arrange { drawing } => return drawing.answer().map(Some),
            Request::Layouts {} => return storage::layouts(&self.common.options).map(Some),
            Request::Source { request } => return self.editor()?.handle(page, request).map(Some),
            Request::SaveLayout { name, layout } => {
                if !layout.is_null() {
                    check_length("the name of the layout", &name, LIMITS.name)?;
                }
                let _one_at_a_time = lock(&self.layouts);
                return storage::save_layout(&self.common.options, &name, layout).map(|()| Some(Value::Null));
            }
            _ => {}
        }
        let none = || Failed::new("the request names no session", "reload the page, or update the program");
        let session = self.registry.get(session.ok_or_else(none)?)?;
        match request {
            Request::Close {} => self.registry.close(session.id).map(|()| Some(Value::Null)),
            Request::At { .. } | Request::Timeline { .. } | Request::Series { .. } | Request::Lines { .. } => {
                session.query(page, id, &request).map(Some)
            }
            Request::Watch { watch } => {
                session.watch(page, watch);
                // A recording has no thread.
                let _ = session.command(commands::Command::Watch);
                Ok(Some(Value::Null))
            }
            Request::Note { text } => {
                check_length("the note", &text, LIMITS.note)?;
                if session.command(commands::Command::Note { page, id, text: text.clone() }).is_ok() {
                    return Ok(None);
                }
                // A recording has no thread.
                session.log(2, LogSource::Note, text);
                Ok(Some(Value::Null))
            }
            Request::Extension { name, message } => {
                let extension = self.common.program.extension(&name).ok_or_else(|| unknown_extension(&name))?;
                match extension.handle(&Message { session: &session, page, id }, message)? {
                    Reply::Done(value) => Ok(Some(value)),
                    Reply::Later => Ok(None),
                }
            }
            Request::SaveSource { component, param } | Request::ParamUses { component, param } => {
                let description = session.description()?;
                let owner = description.components.get(component).ok_or_else(|| unknown("component", component))?;
                let parameter = owner.params.get(param).ok_or_else(|| unknown("parameter", param))?;
                if matches!(request, Request::ParamUses { .. }) {
                    return self.editor().map(|editor| Some(editor.param_uses(&owner.name, parameter)));
                }
                self.editor()?.set_default(page, &owner.name, parameter).map(Some)
            }
            Request::Breakpoints { list } => session.set_breakpoints(&list).map(|()| Some(Value::Null)),
            Request::Coverage { file, component, index } => {
                let visits = session.visits(index)?;
                self.editor()?.coverage(&file, &component, &visits).map(Some)
            }
            Request::NextHit { from_us } => Ok(Some(json!(session.next_hit(from_us)))),
            Request::Compare { other } => {
                recorded::compare(page, id, &session, &*self.registry.get(other)?).map(|()| None)
            }
            Request::RunAgain { settings } => {
                let id = self.registry.next_id();
                let again = recorded::run_again(id, &session, &settings)?;
                self.registry.add(&again)?;
                Ok(Some(json!({ "session": id })))
            }
            Request::KeepRecording { name } => storage::keep(&session, page, id, (&name, None)).map(|()| None),
            Request::KeepSpan { name, from_us, until_us } => {
                storage::keep(&session, page, id, (&name, Some(from_us..=until_us))).map(|()| None)
            }
            Request::SaveTune { params, name } => tune::save(&session, &params, &name).map(Some),
            _ if session.kind == SessionKind::Recording => {
                let help = "open a robot or a world; a recording can be run again with other parameters";
                Err(Failed::new("a recording cannot be operated", help))
            }
            request => session.command(commands::Command::Operate { page, id, request }).map(|()| None),
        }
    }
}

fn unknown_extension(name: &str) -> Failed {
    Failed::new(format!("this program has no extension `{name}`"), "reload the page")
}

fn read_only() -> Failed {
    Failed::new("this server lets pages only watch", "start it without --read-only")
}

impl Manager {
    /// Returns whether pages of a read-only server may send a request. Requests about sources are checked by their editor.
    fn only_reads(&self, request: &Request) -> bool {
        if let Request::Extension { name, message } = request {
            return self.common.program.extension(name).is_some_and(|extension| extension.only_reads(message));
        }
        matches!(
            request,
            Request::Watch { .. }
                | Request::At { .. }
                | Request::Timeline { .. }
                | Request::Series { .. }
                | Request::Lines { .. }
                | Request::Breakpoints { .. }
                | Request::NextHit { .. }
                | Request::Coverage { .. }
                | Request::ParamUses { .. }
                | Request::Recordings {}
                | Request::Arrange { .. }
                | Request::Layouts {}
                | Request::Source { .. }
                | Request::Compare { .. }
        )
    }
}

impl Drop for Manager {
    fn drop(&mut self) {
        // The editor ends the running program before its session is closed.
        self.editor = None;
        self.registry.end();
        // The removal fails if a thread that is still ending has a file there. The folder is one for temporary files.
        let _ = std::fs::remove_dir(&self.common.options.spool);
    }
}

/// Checks the length of a text, characters.
fn check_length(what: &str, text: &str, limit: usize) -> Result<(), Failed> {
    let length = text.chars().count();
    let long = || Failed::new(format!("{what} has {length} characters"), format!("write at most {limit}"));
    (length <= limit).then_some(()).ok_or_else(long)
}
