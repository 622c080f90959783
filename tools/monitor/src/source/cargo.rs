//! Cargo: workspaces, packages, and messages of the compiler.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use bica_vicode::model::Span;
use serde_json::Value;

use super::files::Files;
use crate::protocol::{CodeLevel, CodeMessage, Failed};

/// Largest number of messages that are sent to pages.
const MAX_MESSAGES: usize = 300;
/// Name of the target folder, below that of the workspace. It is separate so that a user's own Cargo never waits for this one.
const TARGET: &str = "vicode";

/// The workspace of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Workspace {
    pub(super) root: PathBuf,
    /// Target folder.
    pub(super) target: PathBuf,
    /// Folder and identifier of each package.
    packages: Vec<(PathBuf, String)>,
}

/// Returns the command `cargo`, run in a folder.
pub(super) fn cargo(folder: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(folder);
    command
}

impl Workspace {
    /// Reads the workspace of a folder with `cargo metadata`.
    pub(super) fn of(folder: &Path) -> Result<Self, Failed> {
        let help = "is `cargo` installed, and is the folder of --source within a package?";
        let mut command = cargo(folder);
        let output = command.args(["metadata", "--no-deps", "--format-version=1"]).stdin(Stdio::null()).output();
        let output = output.map_err(|error| Failed::new(format!("cargo cannot be started: {error}"), help))?;
        let metadata: Option<Value> = serde_json::from_slice(&output.stdout).ok();
        let read = || {
            let metadata = metadata?;
            let path = |key: &str| metadata[key].as_str().map(PathBuf::from);
            let package = |one: &Value| {
                let manifest = Path::new(one["manifest_path"].as_str()?);
                Some((manifest.parent()?.canonicalize().ok()?, one["id"].as_str()?.to_owned()))
            };
            Some(Self {
                root: path("workspace_root")?,
                target: path("target_directory")?.join(TARGET),
                packages: metadata["packages"].as_array()?.iter().filter_map(package).collect(),
            })
        };
        read().ok_or_else(|| {
            let error = String::from_utf8_lossy(&output.stderr);
            Failed::new(format!("there is no workspace at `{}`: {}", folder.display(), error.trim()), help)
        })
    }

    /// Returns the package of a file, and the option of Cargo for its targets if it is an example, a test or a benchmark.
    pub(super) fn package(&self, file: &Path) -> Option<(String, Option<&'static str>)> {
        let within = self.packages.iter().filter(|(folder, _)| file.starts_with(folder));
        let (folder, id) = within.max_by_key(|(folder, _)| folder.as_os_str().len())?;
        let first = file.strip_prefix(folder).ok()?.iter().next()?.to_str()?;
        let targets = [("examples", "--examples"), ("tests", "--tests"), ("benches", "--benches")];
        Some((id.clone(), targets.iter().find(|(name, _)| *name == first).map(|(_, option)| *option)))
    }
}

/// Versions of the saved texts, by file.
pub(super) type Versions = BTreeMap<String, u64>;

impl Files {
    /// Returns the versions of the open texts that are saved.
    pub(super) fn versions(&self) -> Versions {
        let open = self.open();
        let saved = open.values().filter(|file| !file.document.is_changed());
        saved.map(|file| (file.name.clone(), file.document.version())).collect()
    }

    /// Adds the message in a line of Cargo's JSON, if there is none like it yet.
    pub(super) fn add_message(&self, line: &Value, root: &Path, versions: &Versions, messages: &mut Vec<CodeMessage>) {
        if line["reason"] == "compiler-message"
            && messages.len() < MAX_MESSAGES
            && let Some(message) = self.message(&line["message"], root, versions)
            && !messages.contains(&message)
        {
            messages.push(message);
        }
    }

    fn message(&self, message: &Value, root: &Path, versions: &Versions) -> Option<CodeMessage> {
        let level = match message["level"].as_str()? {
            "error" | "error: internal compiler error" => CodeLevel::Error,
            "warning" => CodeLevel::Warning,
            _ => return None,
        };
        let spans = message["spans"].as_array()?;
        let primary: Vec<&Value> = spans.iter().filter(|span| span["is_primary"] == true).collect();
        let place = primary.iter().find_map(|span| self.place(span, root));
        if primary.is_empty() && (level == CodeLevel::Warning || message["message"].as_str()?.starts_with("aborting")) {
            // A summary: the number of warnings, or of errors.
            return None;
        }
        let mut text = message["message"].as_str()?.to_owned();
        if let Some(label) =
            primary.first().and_then(|span| span["label"].as_str()).filter(|label| !text.contains(*label))
        {
            text = format!("{text}: {label}");
        }
        let (file, span, line) = match place {
            Some((file, span, line)) => (Some(file), Some(span), line),
            None => (None, None, 0),
        };
        let version = file.as_ref().and_then(|file| versions.get(file).copied());
        Some(CodeMessage { file, version, span, line, level, text, help: help(message) })
    }

    /// Returns file, span and line of a span below the folder of sources; for code generated by a macro those of the macro's use.
    fn place(&self, span: &Value, root: &Path) -> Option<(String, Span, usize)> {
        let path = root.join(span["file_name"].as_str()?);
        let Some(file) = path.canonicalize().ok().and_then(|path| self.name_of(&path)) else {
            return self.place(span.get("expansion")?.get("span")?, root);
        };
        let number = |key: &str| span[key].as_u64().map(|number| number as usize);
        Some((file, Span::new(number("byte_start")?, number("byte_end")?), number("line_start")?))
    }
}

/// Returns the advice of the compiler.
fn help(message: &Value) -> String {
    let children = message["children"].as_array().map(Vec::as_slice).unwrap_or_default();
    let advice = children.iter().filter_map(|child| {
        let text = child["message"].as_str()?;
        // The option that enables a lint is of no use here.
        if text.contains("on by default") {
            return None;
        }
        let spans = child["spans"].as_array().map(Vec::as_slice).unwrap_or_default();
        let code =
            spans.iter().filter_map(|span| span["suggested_replacement"].as_str()).find(|code| !code.trim().is_empty());
        Some(code.map_or_else(|| text.to_owned(), |code| format!("{text}: `{}`", code.trim())))
    });
    advice.collect::<Vec<_>>().join("\n")
}

/// Parses a line of Cargo's progress: number of crates that are built, and of all crates.
pub(super) fn progress(line: &str) -> Option<(u32, u32)> {
    let (_, rest) = line.trim_start().strip_prefix("Building")?.split_once(']')?;
    let (done, rest) = rest.trim_start().split_once('/')?;
    let total: String = rest.chars().take_while(char::is_ascii_digit).collect();
    Some((done.parse().ok()?, total.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn progress_is_read() {
        assert_eq!(progress("    Building [====>      ] 5/120: serde, libm"), Some((5, 120)));
        assert_eq!(progress("   Compiling serde v1.0.0"), None);
        assert_eq!(progress("Building [=> ] x/3"), None);
    }
}
