//! The compiler's check after each save.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::process::Command;
use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use serde_json::Value;

use super::cargo::{Workspace, cargo};
use super::files::Files;
use super::process::{self, Group, LastLines};
use crate::pages::lock;
use crate::protocol::{Check, CheckState, CodeLevel, CodeMessage, Failed, ToPage};

/// Time from a save to the check.
const AFTER: Duration = Duration::from_millis(200);

/// What is to be checked.
#[derive(Default)]
pub(super) struct Checks {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    /// Files whose packages are to be checked.
    wanted: BTreeSet<PathBuf>,
    due: Option<Instant>,
    running: Option<Group>,
    /// Whether the running check is of old text.
    outdated: bool,
    ended: bool,
    last: Option<Check>,
}

/// How a check ended.
enum Outcome {
    Done(Vec<CodeMessage>),
    Failed(Failed),
    /// A newer edit came, or the server ends.
    GivenUp,
}

impl Checks {
    /// Checks the packages of files soon. A check that runs is given up.
    pub(super) fn want(&self, paths: impl IntoIterator<Item = PathBuf>) {
        let mut state = lock(&self.state);
        state.wanted.extend(paths);
        state.due = Some(Instant::now() + AFTER);
        state.outdated = true;
        if let Some(group) = state.running {
            group.kill();
        }
        self.changed.notify_all();
    }

    /// Ends the check that runs, and the thread.
    pub(super) fn end(&self) {
        let mut state = lock(&self.state);
        state.ended = true;
        if let Some(group) = state.running {
            group.kill();
        }
        self.changed.notify_all();
    }

    /// The last message of it.
    pub(super) fn last(&self) -> Option<Check> {
        lock(&self.state).last.clone()
    }

    /// Waits for what is to be checked; `None` at the end.
    fn next(&self) -> Option<BTreeSet<PathBuf>> {
        let mut state = lock(&self.state);
        loop {
            if state.ended {
                return None;
            }
            let left = state.due.map(|due| due.saturating_duration_since(Instant::now()));
            if left == Some(Duration::ZERO) && !state.wanted.is_empty() {
                (state.due, state.outdated) = (None, false);
                return Some(std::mem::take(&mut state.wanted));
            }
            let wait = left.unwrap_or(Duration::from_mins(1)).max(Duration::from_millis(1));
            let waited = self.changed.wait_timeout(state, wait);
            state = waited.unwrap_or_else(std::sync::PoisonError::into_inner).0;
        }
    }

    fn is_outdated(&self) -> bool {
        let state = lock(&self.state);
        state.outdated || state.ended
    }

    fn set_running(&self, group: Option<Group>) -> bool {
        let mut state = lock(&self.state);
        state.running = group;
        state.outdated || state.ended
    }
}

/// Checks until the end.
pub(super) fn work(checks: &Checks, files: &Arc<Files>) {
    let say = |state, began: Instant, messages: Vec<CodeMessage>| {
        let check = Check { state, seconds: began.elapsed().as_secs_f32(), messages };
        lock(&checks.state).last = Some(check.clone());
        files.pages.broadcast(&ToPage::Check(check));
    };
    let mut last = Vec::new();
    while let Some(paths) = checks.next() {
        let began = Instant::now();
        say(CheckState::Running, began, last.clone());
        match check(checks, files, &paths) {
            Outcome::Done(messages) => {
                last.clone_from(&messages);
                say(CheckState::Done, began, messages);
            }
            Outcome::Failed(failed) => {
                let (text, help) = (failed.text, failed.help);
                let message =
                    CodeMessage { file: None, version: None, span: None, line: 0, level: CodeLevel::Error, text, help };
                say(CheckState::Failed, began, vec![message]);
            }
            Outcome::GivenUp => {
                let mut state = lock(&checks.state);
                state.wanted.extend(paths);
                if state.ended {
                    drop(state);
                    say(CheckState::Stopped, began, last.clone());
                }
            }
        }
    }
}

fn check(checks: &Checks, files: &Files, paths: &BTreeSet<PathBuf>) -> Outcome {
    let versions = files.versions();
    // One run of Cargo for each workspace.
    let mut runs: BTreeMap<PathBuf, (Workspace, BTreeSet<String>)> = BTreeMap::new();
    for path in paths {
        let Some(folder) = path.parent() else { continue };
        let workspace = match Workspace::of(folder) {
            Ok(workspace) => workspace,
            Err(failed) => return Outcome::Failed(failed),
        };
        let Some((package, target)) = workspace.package(path) else { continue };
        let arguments = &mut runs.entry(workspace.root.clone()).or_insert_with(|| (workspace, BTreeSet::new())).1;
        arguments.insert(format!("--package={package}"));
        if let Some(target) = target {
            // These targets need the library, which is checked with them; programs would be left out.
            arguments.extend([target.to_owned(), "--bins".to_owned()]);
        }
    }
    if runs.is_empty() {
        let help =
            "files of a package are checked, those that it does not name in its `Cargo.toml` or by `mod` are not";
        return Outcome::Failed(Failed::new("these files belong to no package", help));
    }
    let mut messages = Vec::new();
    for (workspace, arguments) in runs.into_values() {
        let mut command = cargo(&workspace.root);
        command.args(["check", "--message-format=json", "--target-dir"]).arg(&workspace.target);
        command.args(&arguments);
        let before = messages.len();
        let take = |line: &Value| files.add_message(line, &workspace.root, &versions, &mut messages);
        match run(checks, &mut command, take) {
            Ok((true, _)) => {}
            Ok((false, _)) if messages[before..].iter().any(|message| message.level == CodeLevel::Error) => {}
            _ if checks.is_outdated() => return Outcome::GivenUp,
            Ok((false, last)) => return Outcome::Failed(Failed::new(last, "see the message of Cargo")),
            Err(error) => {
                return Outcome::Failed(Failed::new(format!("cargo cannot be started: {error}"), "is it installed?"));
            }
        }
        if checks.is_outdated() {
            return Outcome::GivenUp;
        }
    }
    Outcome::Done(messages)
}

/// Runs Cargo; returns whether it succeeded, and the last lines of its standard error.
fn run(checks: &Checks, command: &mut Command, mut take: impl FnMut(&Value)) -> std::io::Result<(bool, String)> {
    let (mut child, group) = process::start(command)?;
    if checks.set_running(Some(group)) {
        group.kill();
    }
    let errors = child.stderr.take().map(|stream| {
        std::thread::spawn(move || {
            let mut last = LastLines::default();
            process::each_line(stream, |line| {
                last.add(line);
                true
            });
            last.text()
        })
    });
    if let Some(stream) = child.stdout.take() {
        process::each_line(stream, |line| {
            if let Ok(line) = serde_json::from_str(&line) {
                take(&line);
            }
            true
        });
    }
    let last = errors.and_then(|thread| thread.join().ok()).unwrap_or_default();
    // Before it is waited for: afterwards its number could be that of another program.
    checks.set_running(None);
    let status = child.wait()?;
    Ok((status.success(), last))
}
