//! Files that pages list and save: kept recordings and layouts.

use std::fs::{self, File};
use std::io::{self, BufReader, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use bica_recording::repair::recover;
use serde_json::{Map, Value, json};

use super::keep_robot;
use super::session::Session;
use crate::files::{self, failed, replace};
use crate::options::Options;
use crate::pages::PageId;
use crate::protocol::{Failed, SessionKind};
use bica_wire::message::LogSource;

/// Ending of recordings.
pub(super) const MCAP: &str = ".mcap";
/// Time after which the recorder has written a cycle to its file.
const WRITTEN: Duration = Duration::from_millis(600);
/// Largest file of layouts, bytes.
const MAX_LAYOUTS: usize = 1 << 20;

/// Lists the recordings in the recordings folder, sorted by name.
pub(super) fn recordings(options: &Options) -> Value {
    let Ok(entries) = fs::read_dir(&options.recordings) else { return json!([]) };
    let file = |entry: fs::DirEntry| {
        let name = entry.file_name().into_string().ok().filter(|name| name.ends_with(MCAP))?;
        let data = entry.metadata().ok().filter(fs::Metadata::is_file)?;
        Some((name, data.len()))
    };
    let mut files: Vec<_> = entries.filter_map(Result::ok).filter_map(file).collect();
    files.sort();
    files.into_iter().map(|(name, bytes)| json!({ "name": name, "bytes": bytes, "seconds": null })).collect()
}

/// Writes the recording of a world, or what is remembered of a robot, to the recordings folder, and answers when that is done.
pub(super) fn keep(session: &Arc<Session>, page: PageId, id: u32, name: &str) -> Result<(), Failed> {
    let target = files::path(&session.options.recordings, name, MCAP)?;
    let source = match session.kind {
        SessionKind::World => Some(recorded(session)?),
        SessionKind::Robot => None,
        SessionKind::Recording => {
            return Err(Failed::new("a recording is kept already", "choose a world or a robot"));
        }
    };
    if target.exists() {
        return Err(Failed::new(format!("`{}` exists", target.display()), "choose another name"));
    }
    let session = Arc::clone(session);
    let work = move || {
        let result = match &source {
            Some(source) => {
                thread::sleep(WRITTEN);
                copy(source, &target)
            }
            None => keep_robot::keep(&session, &target),
        };
        match &result {
            Ok(_) => session.log(2, LogSource::Monitor, format!("the recording was kept: {}", target.display())),
            Err(failed) => session.log(4, LogSource::Monitor, format!("the recording was not kept: {}", failed.text)),
        }
        session.pages.answer(page, id, result);
    };
    let started = thread::Builder::new().name("keep".to_owned()).spawn(work);
    started.map(drop).map_err(|error| Failed::new(error.to_string(), "close other programs"))
}

/// Returns the file with the run of a world.
fn recorded(session: &Session) -> Result<PathBuf, Failed> {
    let shared = session.shared();
    if shared.recording_file.exists() {
        return Ok(shared.recording_file.clone());
    }
    let note = &shared.recording.note;
    let reason = if note.is_empty() { "there is no recording of it" } else { note };
    Err(Failed::new(format!("this session is not recorded: {reason}"), "is there room on the disk? Restart the world"))
}

/// Copies all complete chunks of a running recording. What could not be written is removed.
fn copy(spool: &Path, target: &Path) -> Result<Value, Failed> {
    let help = "is the disk full, or the folder write-protected?";
    if let Some(folder) = target.parent() {
        fs::create_dir_all(folder).map_err(|error| failed("make", folder, &error, help))?;
    }
    let source = File::open(spool).map_err(|error| failed("read", spool, &error, help))?;
    let file = File::create_new(target).map_err(|error| failed("write", target, &error, help))?;
    let mut writer = BufWriter::new(file);
    let result = recover(BufReader::new(source), &mut writer, None).map_err(|error| error.to_string());
    let result = result.and_then(|copied| {
        writer.flush().and_then(|()| writer.get_ref().sync_all()).map(|()| copied).map_err(|error| error.to_string())
    });
    match result {
        Ok(copied) => Ok(json!({ "path": target.display().to_string(), "cycles": copied.cycles })),
        Err(error) => {
            // The failure of the writing is what the user has to know.
            let _ = fs::remove_file(target);
            Err(failed("write", target, &error, help))
        }
    }
}

/// Reads all layouts; none if there is no file yet.
pub(super) fn layouts(options: &Options) -> Result<Value, Failed> {
    let help = "mend or remove the file";
    match files::read(&options.layouts) {
        Ok(text) => serde_json::from_str::<Map<String, Value>>(&text)
            .map(Value::Object)
            .map_err(|error| failed("read", &options.layouts, &error, help)),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(json!({})),
        Err(error) => Err(failed("read", &options.layouts, &error, help)),
    }
}

/// Saves or deletes a layout.
pub(super) fn save_layout(options: &Options, name: &str, layout: Value) -> Result<(), Failed> {
    let Value::Object(mut all) = layouts(options)? else { return Ok(()) };
    if layout.is_null() {
        all.remove(name);
    } else {
        all.insert(name.to_owned(), layout);
    }
    let text = Value::Object(all).to_string();
    if text.len() > MAX_LAYOUTS {
        return Err(Failed::new("the layouts are too large", "delete some"));
    }
    replace(&options.layouts, text.as_bytes())
}

/// Makes a folder that other users of the computer cannot read.
pub(super) fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}
