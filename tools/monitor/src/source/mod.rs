//! Sources below one folder, edited by pages.
//!
//! [`Editor`] has one [`Document`](bica_vicode::Document) for each open file, shared by all pages: canvas and code of all of them
//! are views of one text with one history. The files on disk are watched; changes by other programs are merged, and nothing is
//! overwritten. With `--build` the compiler checks what was saved, and the program is built and run.

mod cargo;
mod check;
mod checks;
mod compare;
mod create;
mod default;
mod draw;
mod edit;
mod file;
mod files;
#[cfg(test)]
mod interleavings;
mod limits;
mod process;
mod run;
mod save;
mod search;
mod sidecar;
mod stamp;
mod trial;
mod watch;

use std::path::Path;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use bica_link::Param;
use bica_vicode::Folder;
use bica_vicode::coverage::{Coverage, Visits};
use serde_json::{Value, json};

use self::checks::Checks;
use self::create::New;
use self::files::Files;
pub(crate) use self::run::Host;
use self::run::{Rules, Runs};
use self::watch::End;
use crate::options::Options;
use crate::pages::{PageId, Pages};
use crate::protocol::{Failed, SourceRequest, ToPage};

/// All sources that pages edit.
pub(crate) struct Editor {
    files: Arc<Files>,
    read_only: bool,
    end: Arc<End>,
    threads: Vec<JoinHandle<()>>,
    /// The program that is built and run; none if building is not allowed.
    runs: Option<Arc<Runs>>,
}

impl Editor {
    /// Opens a folder of sources.
    pub(crate) fn new(
        folder: &Path,
        options: &Options,
        pages: &Arc<Pages>,
        host: Arc<dyn Host>,
    ) -> Result<Self, Failed> {
        let folder = Folder::open(folder).map_err(|error| {
            Failed::new(format!("the folder of sources cannot be opened: {error}"), "name a folder with --source")
        })?;
        let may_build = options.build && !options.read_only;
        let checks = may_build.then(Arc::<Checks>::default);
        let files = Arc::new(Files::new(folder, Arc::clone(pages), checks.clone()));
        let runs = may_build.then(|| Arc::new(Runs::new(Arc::clone(&files), host, &options.run)));
        let end = Arc::<End>::default();
        let mut editor =
            Self { files: Arc::clone(&files), read_only: options.read_only, end, threads: Vec::new(), runs };
        let (own, end) = (Arc::clone(&files), Arc::clone(&editor.end));
        editor.spawn("sources", move || watch::watch(&own, &end))?;
        if let Some(checks) = checks {
            editor.spawn("check", move || check::work(&checks, &files))?;
        }
        Ok(editor)
    }

    fn spawn(&mut self, name: &str, work: impl FnOnce() + Send + 'static) -> Result<(), Failed> {
        let started = thread::Builder::new().name(name.to_owned()).spawn(work);
        self.threads.push(started.map_err(|error| Failed::new(error.to_string(), "close other programs"))?);
        Ok(())
    }

    /// Sends the state of check and build to a new page.
    pub(crate) fn greet(&self, page: PageId) {
        if let Some(check) = self.files.checks.as_ref().and_then(|checks| checks.last()) {
            self.files.pages.state(page, ToPage::Check(check));
        }
        if let Some(build) = self.runs.as_ref().and_then(|runs| runs.last()) {
            self.files.pages.state(page, ToPage::Build(build));
        }
    }

    /// Removes a page from all files.
    pub(crate) fn left(&self, page: PageId) {
        self.files.left(page);
    }

    /// Returns the coverage of a machine by the visits of a session.
    pub(crate) fn coverage(&self, file: &str, component: &str, visits: &Visits) -> Result<Value, Failed> {
        self.files.machine(file, component).map(|(_, machine)| json!(Coverage::of(&machine, visits)))
    }

    /// Writes the current value of a parameter to its source, as the new default.
    pub(crate) fn set_default(&self, page: PageId, component: &str, param: &Param) -> Result<Value, Failed> {
        self.writable()?;
        self.files.set_default(page, component, param)
    }

    /// Lists where a parameter is declared and read.
    pub(crate) fn param_uses(&self, component: &str, param: &Param) -> Value {
        json!(self.files.param_uses(component, param))
    }

    fn writable(&self) -> Result<(), Failed> {
        let failed = || Failed::new("this server lets pages only watch", "start it without --read-only");
        if self.read_only { Err(failed()) } else { Ok(()) }
    }

    fn runs(&self) -> Result<&Arc<Runs>, Failed> {
        self.writable()?;
        let failed = || Failed::new("this server does not build programs", "start it with --build");
        self.runs.as_ref().ok_or_else(failed)
    }

    /// Handles a request of a page; returns the answer.
    pub(crate) fn handle(&self, page: PageId, request: SourceRequest) -> Result<Value, Failed> {
        let files = &self.files;
        match request {
            SourceRequest::Sources {} => return Ok(json!(files.sources())),
            SourceRequest::Tables { types } => return Ok(json!(files.tables(&types))),
            SourceRequest::OpenFile { file } => return files.show(page, &file).map(|()| Value::Null),
            SourceRequest::CloseFile { file } => {
                files.hide(page, &file);
                return Ok(Value::Null);
            }
            SourceRequest::Uses { file, component, function } => {
                return files.uses(&file, &component, &function).map(|uses| json!(uses));
            }
            SourceRequest::DrawFile { file, component, format } => return files.draw(&file, &component, format),
            SourceRequest::Fixes { file } => return files.fixes(&file),
            SourceRequest::CompareFile { file } => return files.compare(&file),
            SourceRequest::TryMachine { file, component, steps } => {
                return files.try_machine(&file, &component, &steps);
            }
            _ => self.writable()?,
        }
        match request {
            SourceRequest::EditFile { file, version, edits } => files.edit(page, &file, version, &edits),
            SourceRequest::UndoFile { file } => files.undo(page, &file, false),
            SourceRequest::RedoFile { file } => files.undo(page, &file, true),
            SourceRequest::SaveFile { file } => files.save(&file),
            SourceRequest::ResolveFile { file, keep } => files.resolve(page, &file, keep),
            SourceRequest::MoveStates { file, positions } => files.shift(page, &file, &positions),
            SourceRequest::ArrangeStates { file, component } => files.arrange(page, &file, &component),
            SourceRequest::ChangeNote { file, component, from, to } => {
                files.change_note(page, &file, &component, (from, to))
            }
            SourceRequest::RenameUses { file, component, function, to, places } => {
                files.rename(page, &file, [component, function, to], &places)
            }
            SourceRequest::NewComponent { name, folder, tree, import, dry } => {
                files.create(page, &New { name, folder, tree, import }, dry)
            }
            SourceRequest::Check {} => self.runs().and_then(|_| self.check()).map(|()| Value::Null),
            SourceRequest::Run { seed, robots } => {
                self.runs()?;
                self.save_all()?;
                self.runs()?.start(Rules { seed, robots }).map(|()| Value::Null)
            }
            SourceRequest::StopRun {} => {
                self.runs()?.stop();
                Ok(Value::Null)
            }
            _ => Err(Failed::new("this request is not known yet", "reload the page, or update the program")),
        }
    }

    /// Saves all changed texts, because the compiler reads the files.
    fn save_all(&self) -> Result<(), Failed> {
        let open = self.files.open();
        let changed: Vec<String> =
            open.values().filter(|file| file.document.is_changed()).map(|file| file.name.clone()).collect();
        drop(open);
        changed.iter().try_for_each(|name| self.files.save(name).map(drop))
    }

    fn check(&self) -> Result<(), Failed> {
        self.save_all()?;
        let paths: Vec<_> = self.files.open().values().map(|file| file.path.clone()).collect();
        if paths.is_empty() {
            return Err(Failed::new("no file is open", "open one: its package is checked"));
        }
        if let Some(checks) = &self.files.checks {
            checks.want(paths);
        }
        Ok(())
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        if let Some(checks) = &self.files.checks {
            checks.end();
        }
        if let Some(runs) = &self.runs {
            runs.stop();
        }
        self.end.now();
        for thread in self.threads.drain(..) {
            // A thread that has panicked has written its message already.
            let _ = thread.join();
        }
        self.files.finish();
    }
}
