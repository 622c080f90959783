//! Files of the last commit.

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Stdio};

/// A file in the last commit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Committed {
    /// Abbreviated name of the commit.
    pub revision: String,
    /// Text of the file; `None` if the commit does not have it.
    pub text: Option<String>,
}

/// Reads a file from the last commit of the Git repository that contains it. Filters and text conversions of the repository do not run.
///
/// # Errors
/// If the file is in no repository, the repository has no commit, or Git is not installed.
pub fn committed(file: &Path) -> Result<Committed, String> {
    let name = file.file_name().ok_or_else(|| format!("`{}` is no file", file.display()))?;
    let folder = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let revision = git(folder, ["rev-parse", "--short", "--verify", "HEAD"].map(OsStr::new))?;
    let revision = revision.ok_or_else(|| {
        format!("`{}` is in no Git repository with a commit: name two files to compare", file.display())
    })?;
    let mut blob = OsStr::new("HEAD:./").to_owned();
    blob.push(name);
    let text = git(folder, [OsStr::new("cat-file"), OsStr::new("blob"), &blob])?;
    Ok(Committed { revision: revision.trim().to_owned(), text })
}

/// Runs Git; returns its standard output, `None` if it fails.
fn git<const N: usize>(folder: &Path, arguments: [&OsStr; N]) -> Result<Option<String>, String> {
    let mut command = Command::new("git");
    command.arg("-C").arg(folder).arg("--no-optional-locks").args(arguments).stdin(Stdio::null());
    let output =
        command.output().map_err(|error| format!("cannot run `git`: {error}: install Git, or name two files"))?;
    let text = String::from_utf8(output.stdout).map_err(|_| "the file in the last commit is not UTF-8".to_owned())?;
    Ok(output.status.success().then_some(text))
}
