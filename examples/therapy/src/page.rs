//! Therapist's page, a panel of the monitor. This part reads sessions; `panels/therapist.js` shows them.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use bica_app::Failure;
use bica_app::bica_monitor::program::{Asked, Extension, Reply};
use bica_app::bica_monitor::protocol::Failed;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::cli;
use crate::record;
use crate::script::Script;
use crate::session::{self, Step, Until};

/// The panel, with the options of the world from the command line; the option `session` names the session.
pub(crate) struct Page(BTreeMap<String, String>);

/// Session of a world that the page opened.
#[derive(Default)]
struct Chosen(Option<PathBuf>);

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
enum Message {
    /// Reads the session of this world: its title, its steps, and the sessions in the same folder.
    Read,
    /// Checks a session before its world is opened.
    Check { file: PathBuf },
    /// Sets the session of this world, which the page has chosen.
    Chose { file: PathBuf },
}

impl Page {
    /// Creates the panel from the arguments of the program, which contain `--option session=FILE`.
    pub(crate) fn new(arguments: &[OsString]) -> Self {
        let options = arguments.windows(2).filter(|two| two[0] == "--option");
        let options = options.filter_map(|two| two[1].to_str()?.split_once('='));
        Self(options.map(|(name, value)| (name.to_owned(), value.to_owned())).collect())
    }

    /// Checks the session and the folder of the records before the page starts.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let option = |name: &str| self.0.get(name).filter(|value| !value.is_empty());
        option("session").map(|file| cli::open(Path::new(file))).transpose()?;
        let folder = || Path::new(option("records").map_or(".", String::as_str));
        option("code").map_or(Ok(()), |code| record::check(folder(), code))
    }
}

impl Extension for Page {
    fn name(&self) -> &'static str {
        "therapist"
    }

    fn module(&self) -> &'static str {
        include_str!("../panels/therapist.js")
    }

    fn only_reads(&self, message: &Value) -> bool {
        message["type"] != "chose"
    }

    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed> {
        let wrong = |error: serde_json::Error| Failed::new(error.to_string(), "load the page again");
        Ok(Reply::Done(match serde_json::from_value(message).map_err(wrong)? {
            Message::Read => {
                let chosen = asked.memory().of::<Chosen>().0.clone();
                let first = || self.0.get("session").map(PathBuf::from).unwrap_or_default();
                let mut session = read(&chosen.unwrap_or_else(first))?;
                session["options"] = json!(self.0);
                session
            }
            Message::Check { file } => read(&file)?,
            Message::Chose { file } => {
                asked.memory().of::<Chosen>().0 = Some(file);
                Value::Null
            }
        }))
    }
}

/// Returns a session as JSON for the page.
fn read(file: &Path) -> Result<Value, Failed> {
    let script = cli::open(file).map_err(|failure| match failure {
        Failure::Error { what, help } => Failed::new(what, help),
        Failure::BrokenPipe => Failed::new("the session cannot be read", "try again"),
    })?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let beside = fs::read_dir(if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
    let beside = beside.into_iter().flatten().flatten().map(|entry| folder.join(entry.file_name()));
    let mut files: Vec<_> = beside.filter(|file| file.extension().is_some_and(|ending| ending == "session")).collect();
    files.sort();
    let text = fs::read(file).ok().and_then(|bytes| Script::decode(&bytes).ok()).unwrap_or_default();
    let lines: Vec<_> = text.lines().map(str::trim).collect();
    let parts = parts(&script, &lines);
    Ok(
        json!({ "title": script.title, "file": file, "files": files, "lines": lines, "steps": script.lines, "parts": parts }),
    )
}

/// Parts of a session between two waits. Each has its first step, the line and the text of its most important command,
/// and the spoken text.
fn parts(script: &Script, lines: &[&str]) -> Vec<Value> {
    let starts: Vec<_> = (0..script.steps.len()).filter(|step| session::begins(&script.steps, *step)).collect();
    let line = |step: usize| lines.get(script.lines[step] - 1).copied().unwrap_or_default();
    let ends = starts.iter().skip(1).copied().chain([script.steps.len()]);
    let part = |(&from, to): (&usize, usize)| {
        let says = |step: &usize| matches!(script.steps[*step], Step::Speak(_));
        let shown = (from..to).min_by_key(|step| importance(script.steps[*step]))?;
        let says = (from..to).find(says).map(line);
        let worth = importance(script.steps[shown]) < 9;
        worth.then(|| json!({ "step": from, "line": script.lines[shown], "does": line(shown), "says": says }))
    };
    starts.iter().zip(ends).filter_map(part).collect()
}

/// Rank of a step in the summary of a part: 0 is the most important, 9 is not shown.
const fn importance(step: Step) -> u8 {
    match step {
        Step::Exercise { .. } => 0,
        Step::Move(..) => 1,
        Step::Walk(_) => 2,
        Step::Play(_) => 3,
        Step::Speak(_) => 4,
        Step::Wait(Until::Signal(_), _) => 5,
        _ => 9,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn session_is_shown_in_parts() {
        let text = "say \"Hello.\"\nwait speech at most 9 s\n\nlight eyes red\nsay \"Up.\"\nmovement nod\nwait all at most 9 s\nwait 1 s\n\
            exercise arms_open reps 2 at most 9 s\nvolume 9";
        let parts = parts(&Script::parse(text).expect("a right script"), &text.lines().collect::<Vec<_>>());
        let found = parts.iter().map(|part| (part["step"].as_u64(), part["does"].as_str(), part["says"].as_str()));
        let (hello, up) = ("say \"Hello.\"", "say \"Up.\"");
        let nod = (Some(2), Some("movement nod"), Some(up));
        let exercise = (Some(7), Some("exercise arms_open reps 2 at most 9 s"), None);
        assert_eq!(found.collect::<Vec<_>>(), [(Some(0), Some(hello), Some(hello)), nod, exercise]);
    }
}
