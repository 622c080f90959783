//! Files that pages list and save: kept recordings and layouts.

use std::fs::{self, File};
use std::io::{self, BufReader, BufWriter, Write as _};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use bica_recording::Error;
use bica_recording::repair::{Copied, recover, trim};
use serde_json::{Map, Value, json};

use super::keep_robot;
use super::session::Session;
use crate::files::{self, WRITE_HELP, failed, make_folder_of, replace};
use crate::options::Options;
use crate::pages::PageId;
use crate::protocol::{Failed, SessionKind};
use bica_wire::message::LogSource;

/// Ending of recordings.
pub(super) const MCAP: &str = ".mcap";
/// Time after which the recorder has written a cycle to its file.
const WRITTEN: Duration = Duration::from_millis(600);
/// Ending of a temporary copy, from which a span is cut when it is complete.
const WHOLE: &str = "whole";
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

/// Source of a kept recording.
enum Source {
    /// The file of a world's run, which continues.
    Run(PathBuf),
    /// The history of a robot's session.
    Memory,
    /// A recording.
    File(PathBuf),
}

/// Writes a recording, or a span of it, µs, to a file of the recordings folder, and answers when it is written.
pub(super) fn keep(
    session: &Arc<Session>,
    page: PageId,
    id: u32,
    (name, span): (&str, Option<RangeInclusive<u64>>),
) -> Result<(), Failed> {
    let target = files::path(&session.options.recordings, name, MCAP)?;
    let source = match session.kind {
        SessionKind::World => Source::Run(recorded(session)?),
        SessionKind::Robot => Source::Memory,
        SessionKind::Recording if span.is_some() => Source::File(session.recording_path()),
        SessionKind::Recording => {
            return Err(Failed::new("a recording is kept already", "choose a world or a robot"));
        }
    };
    if target.exists() {
        return Err(Failed::new(format!("`{}` exists", target.display()), "choose another name"));
    }
    let session = Arc::clone(session);
    let work = move || {
        let result = match span {
            None => write(&session, &source, &target),
            Some(span) => cut(&session, &source, &target, &span),
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

/// Writes a whole source.
fn write(session: &Arc<Session>, source: &Source, target: &Path) -> Result<Value, Failed> {
    match source {
        Source::Run(spool) => {
            thread::sleep(WRITTEN);
            copy(spool, target, |source, target| recover(source, target, None))
        }
        Source::Memory => keep_robot::keep(session, target),
        Source::File(file) => copy(file, target, |source, target| recover(source, target, None)),
    }
}

/// Writes a span of a source.
fn cut(session: &Arc<Session>, source: &Source, target: &Path, span: &RangeInclusive<u64>) -> Result<Value, Failed> {
    let (first, known) = session.shared().history.span();
    // Times of a robot are since its start, those in a file since its first cycle.
    let zero = if matches!(source, Source::Memory) { first } else { 0 };
    let ns = |time_us: u64| time_us.saturating_sub(zero).saturating_mul(1000);
    // The last cycle may not be written yet.
    let until = if *span.end() >= known { u64::MAX } else { ns(*span.end()) };
    let trimmed =
        |whole: &Path| copy(whole, target, |source, target| trim(source, target, ns(*span.start()), until, None));
    if let Source::File(file) = source {
        return trimmed(file);
    }
    let whole = target.with_extension(WHOLE);
    let result = write(session, source, &whole).and_then(|_| trimmed(&whole));
    let _ = fs::remove_file(&whole);
    result
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

/// Copies a recording with the function `by`. An incomplete copy is removed.
fn copy(
    source: &Path,
    target: &Path,
    by: impl FnOnce(BufReader<File>, &mut BufWriter<File>) -> Result<Copied, Error>,
) -> Result<Value, Failed> {
    make_folder_of(target)?;
    let source = File::open(source).map_err(|error| failed("read", source, &error, WRITE_HELP))?;
    let file = File::create_new(target).map_err(|error| failed("write", target, &error, WRITE_HELP))?;
    let mut writer = BufWriter::new(file);
    let wrong = |error: Error| match error {
        Error::Span { .. } => Failed::new(error.to_string(), "choose another span"),
        error => failed("write", target, &error, WRITE_HELP),
    };
    let result = by(BufReader::new(source), &mut writer).and_then(|copied| {
        writer.flush()?;
        writer.get_ref().sync_all()?;
        Ok(json!({ "path": target.display().to_string(), "cycles": copied.cycles }))
    });
    result.map_err(|error| {
        // A failed removal is ignored: the user needs the error of the write.
        let _ = fs::remove_file(target);
        wrong(error)
    })
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

/// Creates a folder that other users of the computer cannot read.
pub(super) fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}
