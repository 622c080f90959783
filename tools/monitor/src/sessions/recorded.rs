//! Recordings as sessions.

mod index;

use std::fs;
use std::io::{BufReader, Read as _};
use std::path::Path;
use std::sync::Arc;
use std::thread;

use bica::runner::STACK_BYTES;
use bica_link::Description;
use bica_recording::ReplayReport;
use bica_wire::model::NamedSetting;
use serde_json::{Value, json};

use super::commands::Commands;
use super::common::Common;
use super::session::Session;
use super::storage::MCAP;
use crate::files;
use crate::pages::PageId;
use crate::program::Rerun;
use crate::protocol::{Connection, Failed, SessionId, SessionKind};

fn new_session((id, name): (SessionId, String), path: &Path, common: &Common) -> Arc<Session> {
    // Commands have no receiver: a recording cannot be operated.
    let commands = Commands::of_nobody();
    let identity = (id, SessionKind::Recording, name);
    let session = Session::new(identity, common.clone(), commands, None);
    path.clone_into(&mut session.shared().recorded.path);
    Arc::new(session)
}

/// Opens a recording of the recordings folder. It is read in the background.
pub(super) fn open(id: SessionId, common: &Common, name: &str) -> Result<Arc<Session>, Failed> {
    let path = files::path(&common.options.recordings, name, MCAP)?;
    // The header is read at once, so that a file that is no recording is refused here.
    let recording = index::open(&path)?;
    let session = new_session((id, name.to_owned()), &path, common);
    let own = Arc::clone(&session);
    spawn("index", move || index::read(&own, recording))?;
    Ok(session)
}

/// Runs a recording again with other parameters; the new recording is a new session.
pub(super) fn run_again(id: SessionId, original: &Session, settings: &[NamedSetting]) -> Result<Arc<Session>, Failed> {
    let path = original.shared().recorded.path.clone();
    if path.as_os_str().is_empty() || !original.shared().can.run_again {
        return Err(Failed::new("this session cannot be run again", "keep a recording, open it, and run that again"));
    }
    let set = assignments(&*original.description()?, settings)?;
    let (options, pages, program) =
        (Arc::clone(&original.options), Arc::clone(&original.pages), Arc::clone(&original.program));
    let common = Common { options, pages, program };
    let options = &original.options;
    super::storage::make_private(&options.spool)
        .map_err(|error| files::failed("make", &options.spool, &error, files::WRITE_HELP))?;
    let out = options.spool.join(format!("again-{id}{MCAP}"));
    let name =
        format!("{}, again: {}", original.name, if set.is_empty() { "as it was".to_owned() } else { set.join(" ") });
    let session = new_session((id, name), &out, &common);
    session.inherit(original);
    let own = Arc::clone(&session);
    spawn("again", move || {
        let mut progress = |seconds: f64| {
            own.set_connection(Connection::Connecting, format!("runs again: {seconds:.0} s done"));
            !own.is_closed()
        };
        let result = rerun_of(&own).and_then(|rerun| Ok(rerun(&path, &set, &out, &mut progress)?));
        match result.and_then(|()| index::open(&out)) {
            Ok(recording) => index::read(&own, recording),
            Err(failed) => own.set_connection(Connection::Ended, format!("{}: {}", failed.text, failed.help)),
        }
    })?;
    Ok(session)
}

fn rerun_of(session: &Session) -> Result<&Rerun, Failed> {
    let none = || Failed::new("this program runs no recordings again", "open them with the program of their robot");
    session.program.rerun.as_ref().ok_or_else(none)
}

fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> Result<(), Failed> {
    let started = thread::Builder::new().name(name.to_owned()).stack_size(STACK_BYTES).spawn(work);
    started.map(drop).map_err(|error| Failed::new(error.to_string(), "close other programs"))
}

/// Returns the settings as assignments of the command line.
fn assignments(description: &Description, settings: &[NamedSetting]) -> Result<Vec<String>, Failed> {
    settings.iter().map(|setting| Ok(description.setting(setting).map(|_| setting.to_string())?)).collect()
}

/// Compares two recordings in a new thread, and answers with the first difference.
pub(super) fn compare(page: PageId, id: u32, one: &Arc<Session>, other: &Session) -> Result<(), Failed> {
    for session in [&**one, other] {
        if session.shared().connection == Connection::Connecting && session.kind == SessionKind::Recording {
            let text = format!("`{}` is still being read or run again", session.name);
            return Err(Failed::new(text, "wait until it is complete, then compare"));
        }
    }
    // Both may be the same session, whose lock must not be taken twice at once.
    let path = |session: &Session| session.shared().recorded.path.clone();
    let paths = [path(one), path(other)];
    if paths.iter().any(|path| path.as_os_str().is_empty()) {
        return Err(Failed::new("only recordings are compared", "keep a recording of the live session, and open it"));
    }
    let session = Arc::clone(one);
    spawn("compare", move || {
        let [path, other] = &paths;
        if have_same_content(path, other) {
            return session.pages.answer(page, id, Ok(json!({ "equal": true, "copies": true })));
        }
        let answer = bica_recording::compare(path, other).map(answer).map_err(Failed::from);
        session.pages.answer(page, id, answer);
    })
}

/// Returns the answer with the first difference of two recordings.
fn answer(report: ReplayReport) -> Value {
    let Some(first) = report.first_difference else { return json!({ "equal": true, "cycles": report.cycles }) };
    let text = first.text(["the first recording", "the second one"]);
    let time_us = (first.t * 1e6).round() as u64;
    json!({
        "equal": false, "cycle": first.cycle, "time_us": time_us, "field": first.field, "text": text,
        "decisions": report.decisions,
    })
}

/// Returns whether two files are copies of each other. An unreadable file is reported by the later comparison of cycles.
fn have_same_content(one: &Path, other: &Path) -> bool {
    let bytes = |path: &Path| Some(BufReader::new(files::open(path).ok()?).bytes().map_while(Result::ok));
    let length = |path: &Path| fs::metadata(path).ok().map(|file| file.len());
    length(one) == length(other) && bytes(one).zip(bytes(other)).is_some_and(|(one, other)| one.eq(other))
}
