//! The compiler's check after each save.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use serde_json::Value;

use super::cargo::{Workspace, cargo};
use super::checks::Checks;
use super::files::Files;
use super::process::{self, LastLines};
use crate::pages::lock;
use crate::protocol::{Check, CheckState, CodeLevel, CodeMessage, Failed, ToPage};

/// Result of a check.
enum Outcome {
    Done(Vec<CodeMessage>),
    Failed(Failed),
    /// Cancelled by a newer edit, or because the server ends.
    GivenUp,
}

/// Executes the requested checks until the server ends.
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
            // Cargo checks the library with these targets, because they need it, but without `--bins` it would leave out the programs.
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
    // Cleared before the wait: afterwards another program could have the number of this process.
    checks.set_running(None);
    let status = child.wait()?;
    Ok((status.success(), last))
}
