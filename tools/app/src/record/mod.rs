//! `record`: prints, repairs, trims, joins and plays recordings.

mod args;
mod file;
mod play;

use std::fs::{self, File};
use std::io::{BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

use bica_recording::repair::{self, Copied};
use bica_recording::{Error, Info, JobCounts, Recordable, Robots, RunPart, RunParts, Topics, create, upgrade};
use serde::Serialize;

use args::{Files, InfoArgs, Merge, Out, RecordAction, Recover, Trim};

use crate::console::{Console, Failure, Outcome, Style};
use crate::values::end_of_span;
pub(crate) use args::Record;
pub use file::{Images, RecordArgs, RecordedFile, TopicsArg};

/// Runs the subcommand.
pub(crate) fn run<R: Recordable + Default>(args: &Record) -> Result<Outcome, Failure> {
    match &args.action {
        RecordAction::Info(args) => info(args),
        RecordAction::Recover(Recover { files, topics }) => {
            rewrite(files, "recovered", |source, target| repair::recover(source, target, topics.map(Topics::from)))
        }
        RecordAction::Trim(Trim { written: Recover { files, topics }, from, until }) => {
            // The conversion saturates: infinity is the largest time.
            let [from, until] = [*from, end_of_span(*from, *until)?].map(|seconds| (seconds * 1e9) as u64);
            let topics = topics.map(Topics::from);
            rewrite(files, "trimmed", |source, target| repair::trim(source, target, from, until, topics))
        }
        RecordAction::Merge(args) => merge(args),
        RecordAction::Play(args) => play::play::<R>(args),
        RecordAction::Upgrade(files) => rewrite(files, "upgraded", |source, target| upgrade(source, target)),
    }
}

/// Joins the files if all are parts of runs; otherwise merges them as recordings of several robots.
fn merge(Merge { out, files, topics }: &Merge) -> Result<Outcome, Failure> {
    let topics = topics.map(Topics::from);
    if RunPart::are_all(files)? {
        let parts = RunParts::open(files)?;
        write(out, files, "joined", |target| Ok(parts.join(target, topics)?))
    } else {
        let robots = Robots::open(files, topics)?;
        write(out, files, "merged", |target| Ok(robots.merge(target)?))
    }
}

#[derive(Serialize)]
struct InfoReport<'a> {
    schema: &'static str,
    file: String,
    #[serde(flatten)]
    info: &'a Info,
}

fn info(args: &InfoArgs) -> Result<Outcome, Failure> {
    let console = Console::new(args.json);
    let info = Info::read(open(&args.file)?).map_err(|error| error.of(&args.file))?;
    print(console, &info)?;
    let file = args.file.display().to_string();
    console.print_json(&InfoReport { schema: "bica/recording/1", file, info: &info })?;
    Ok(Outcome::Success)
}

fn print(console: Console, info: &Info) -> Result<(), Failure> {
    let header = &info.header;
    let program = &header.program;
    let dirty = if program.git_dirty { ", with changes" } else { "" };
    let commit = if program.git_hash.is_empty() { "unknown commit" } else { &program.git_hash };
    let version = if program.version.is_empty() { "unknown version" } else { &program.version };
    console.print_row("program", &format!("{version} at {commit}{dirty}, for {}", program.target))?;
    if !program.bica.is_empty() {
        console.print_row("made with", &format!("BICA {}", program.bica))?;
    }
    if !program.processor.is_empty() {
        console.print_row("processor", &program.processor)?;
    }
    console.print_row("begun", &format!("{} on {}", header.start.time, header.start.host))?;
    let tree = &header.tree;
    let count = tree.components.len();
    console
        .print_row("tree", &format!("{}, {count} components, {} Hz, hash {}", tree.name, tree.cycle_hz, tree.hash))?;
    if let Some(part) = &header.part {
        console.print_row("part", &format!("{} of the run {}", part.number, part.run))?;
    }
    if let Some(monitor) = &header.monitor {
        let (address, lacks) = (&monitor.address, monitor.lacks.join(", "));
        let text = format!("what {address} sent, without {lacks}: not for a replay");
        console.print_row("monitor", &text)?;
    }
    if !header.set_up.is_empty() {
        let one = |(name, value): (&String, &serde_json::Value)| match value.as_str() {
            Some(text) => format!("{name} {text}"),
            None => format!("{name} {value}"),
        };
        console.print_row("set-up", &header.set_up.iter().map(one).collect::<Vec<_>>().join(", "))?;
    }
    let params = tree.components.iter().flat_map(|owner| owner.params.iter().map(move |param| (owner, param)));
    let changed: Vec<_> = params.clone().filter(|(_, param)| param.current() != param.default).collect();
    let (all, count) = (params.count(), changed.len());
    console.print_row("parameters", &format!("{all}, of which {count} are not the defaults"))?;
    for (owner, param) in changed {
        let value = param.kind.text(param.current());
        console.print_row("parameter", &format!("{}.{}={value}", owner.name, param.name))?;
    }
    let (bytes, chunks) = (info.bytes as f64 * 1e-6, info.chunks);
    console.print_row(
        "length",
        &format!("{:.2} s, {} cycles, {bytes:.2} MB, {chunks} chunks", info.seconds, info.cycles),
    )?;
    for (name, jobs) in &info.jobs {
        let JobCounts { begun, on_time, late, failed } = jobs;
        console.print_row("work", &format!("{name}: {begun} jobs, {on_time} on time, {late} late, {failed} failed"))?;
    }
    if !info.fingerprint.is_empty() {
        console.print_row("fingerprint", &info.fingerprint)?;
    }
    // Many worlds have no other result than the fingerprint.
    let results = info.ending.iter().flat_map(|ending| ending.result.lines());
    for result in results.filter(|result| !result.is_empty() && !result.starts_with("fingerprint")) {
        console.print_row("result", result)?;
    }
    for figure in info.ending.iter().flat_map(|ending| &ending.figures) {
        console.print_row("figure", &figure.to_string())?;
    }
    match (&info.ending, &info.damage) {
        (_, Some(damage)) => console.print_row("file", &console.styled(Style::Bad, damage))?,
        (Some(ending), None) => {
            let dropped = match ending.dropped_images {
                0 => String::new(),
                count => format!(", {count} images dropped"),
            };
            let reason = if ending.reason.is_empty() { "complete" } else { &ending.reason };
            console.print_row("file", &format!("{reason}{dropped}"))?;
        }
        (None, None) => console.print_row("file", "complete, without an ending")?,
    }
    console.print("")?;
    console.print(&console.styled(Style::Strong, &format!("{:<12} {:>10} {:>12}", "channel", "messages", "bytes")))?;
    for channel in &info.channels {
        console.print(&format!("{:<12} {:>10} {:>12}", channel.topic, channel.messages, channel.bytes))?;
    }
    let lines = info.events.iter().map(|event| (event.t, format!("{} {}", event.event, event.detail)));
    let requests = info.requests.iter().map(|request| (request.t, format!("request: {}", request.request)));
    let mut lines: Vec<_> = lines.chain(requests).collect();
    lines.sort_by(|one, two| one.0.total_cmp(&two.0));
    for (index, (t, text)) in lines.iter().enumerate() {
        if index == 0 {
            console.print("")?;
        }
        console.print(&format!("{t:>8.2}  {}", text.trim_end()))?;
    }
    Ok(())
}

#[derive(Serialize)]
struct Written<'a> {
    schema: &'static str,
    file: String,
    cycles: u64,
    bytes: u64,
    chunks: u64,
    damages: &'a [String],
}

/// Writes a new file from a recording.
fn rewrite(
    args: &Files,
    done: &str,
    copy: impl FnOnce(BufReader<File>, &mut BufWriter<File>) -> Result<Copied, Error>,
) -> Result<Outcome, Failure> {
    let source = open(&args.file)?;
    let copy = |target: &mut _| copy(source, target).map_err(|error| error.of(&args.file).into());
    write(&args.out, std::slice::from_ref(&args.file), done, copy)
}

/// Writes a new file from others.
fn write(
    args: &Out,
    sources: &[PathBuf],
    done: &str,
    copy: impl FnOnce(&mut BufWriter<File>) -> Result<Copied, Failure>,
) -> Result<Outcome, Failure> {
    if let Some(source) = sources.iter().find(|source| is_same_file(source, &args.path)) {
        let what = format!("`{}` and OUT are the same file", source.display());
        return Err(Failure::new(what, "name another OUT"));
    }
    let console = Console::new(args.json);
    let help = if args.path.exists() && !args.force {
        "--force replaces an existing file"
    } else {
        "name a file that can be written"
    };
    let target = create(&args.path, args.force).map_err(|error| Failure::of_path("write", &args.path, &error, help))?;
    let mut target = BufWriter::with_capacity(1 << 16, target);
    let copied = copy(&mut target).inspect_err(|_| {
        // An incomplete file has no use. The user needs the first error, not an error of the removal.
        let _ = fs::remove_file(&args.path);
    })?;
    target.flush().map_err(|error| Failure::of_path("write", &args.path, &error, "is the disk full?"))?;
    let text = format!("{} cycles, {:.2} MB in {}", copied.cycles, copied.bytes as f64 * 1e-6, args.path.display());
    console.print_row(done, &text)?;
    for damage in &copied.damage {
        console.print_row("lost", &console.styled(Style::Bad, damage))?;
    }
    let Copied { cycles, bytes, chunks, damage } = &copied;
    let file = args.path.display().to_string();
    let schema = "bica/written/1";
    console.print_json(&Written { schema, file, cycles: *cycles, bytes: *bytes, chunks: *chunks, damages: damage })?;
    Ok(Outcome::Success)
}

/// Returns whether two paths name the same file, also through symbolic or hard links.
fn is_same_file(one: &Path, two: &Path) -> bool {
    #[cfg(unix)]
    let identity = |path: &Path| {
        use std::os::unix::fs::MetadataExt as _;
        fs::metadata(path).map(|file| (file.dev(), file.ino())).ok()
    };
    #[cfg(not(unix))]
    let identity = |path: &Path| fs::canonicalize(path).ok();
    identity(one).is_some_and(|one| identity(two) == Some(one))
}

fn open(path: &Path) -> Result<BufReader<File>, Failure> {
    Ok(bica_recording::open(path).map_err(|error| error.of(path))?)
}
