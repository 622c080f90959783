//! Records of sessions: a pseudonymous code, times, counts and angles; no names and no images.

mod report;

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use bica_app::Failure;
use serde::{Deserialize, Serialize};

pub(crate) use report::report;

use crate::cli;
use crate::exercise::Attempt;

/// First line of a record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Head {
    pub(crate) code: String,
    pub(crate) session: String,
    /// Start, seconds since 1970.
    pub(crate) begun: u64,
}

/// Line of a record for one repetition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Entry {
    /// Time since the start, s.
    pub(crate) seconds: f32,
    /// Line of the exercise in the text of the session.
    pub(crate) line: usize,
    pub(crate) verdict: String,
    pub(crate) reasons: Vec<String>,
    /// Largest angle of the arm, degrees.
    pub(crate) peak: f32,
    /// Angle that suffices, degrees.
    pub(crate) goal: f32,
}

/// Record file, written while the session runs: one line of JSON for each repetition.
#[derive(Debug)]
pub(crate) struct Record {
    path: PathBuf,
    file: File,
    /// Line in the text for each step.
    lines: Vec<usize>,
}

const HELP: &str = "give a folder that exists and can be written";

/// Checks a code: 1 to 16 letters, digits and hyphens.
pub(crate) fn check_code(code: &str) -> Result<(), Failure> {
    let fits = (1..=16).contains(&code.len()) && code.chars().all(|sign| sign.is_ascii_alphanumeric() || sign == '-');
    let what = || format!("`{code}` is not a code of 1 to 16 letters, digits and hyphens");
    if fits { Ok(()) } else { Err(Failure::new(what(), "choose a code such as K-27, not a name")) }
}

/// Checks a code, and that the folder of its records exists.
pub(crate) fn check(folder: &Path, code: &str) -> Result<(), Failure> {
    check_code(code)?;
    let what = || format!("the folder for records `{}` does not exist", folder.display());
    if folder.is_dir() {
        Ok(())
    } else {
        Err(Failure::new(what(), "create it, or give another one: --option records=FOLDER"))
    }
}

impl Record {
    /// Creates a new record file in a folder.
    pub(crate) fn begin(folder: &Path, code: &str, session: &str, lines: Vec<usize>) -> Result<Self, Failure> {
        check(folder, code)?;
        let begun = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
        let mut paths = (1..10_000).map(|number| folder.join(format!("{code}_{number:04}.jsonl")));
        let path = paths.find(|path| !path.exists()).unwrap_or_default();
        let file = File::create_new(&path).map_err(|error| Failure::of_path("create", &path, &error, HELP))?;
        let mut record = Self { path, file, lines };
        record.write(&Head { code: code.to_owned(), session: session.to_owned(), begun })?;
        Ok(record)
    }

    /// Appends a repetition.
    pub(crate) fn note(&mut self, seconds: f32, (step, attempt): (u16, Attempt)) -> Result<(), Failure> {
        let line = self.lines.get(usize::from(step)).copied().unwrap_or_default();
        let Attempt { reasons, peak, goal } = attempt;
        let (verdict, reasons) = (reasons.verdict().name().to_owned(), reasons.names().map(str::to_owned).collect());
        self.write(&Entry { seconds, line, verdict, reasons, peak, goal })
    }

    fn write(&mut self, value: &impl Serialize) -> Result<(), Failure> {
        let text = serde_json::to_string(value).unwrap_or_default() + "\n";
        self.file.write_all(text.as_bytes()).map_err(|error| Failure::of_path("write", &self.path, &error, HELP))
    }
}

/// Record files of a code in a folder, sorted.
fn files(folder: &Path, code: &str) -> Result<Vec<PathBuf>, Failure> {
    check_code(code)?;
    let mut paths = cli::files(folder, "give the folder of the records")?;
    paths.retain(|path| {
        let name = path.file_name().and_then(|name| name.to_str());
        name.and_then(|name| name.strip_suffix(".jsonl")?.rsplit_once('_')).is_some_and(|(owner, _)| owner == code)
    });
    if paths.is_empty() {
        let what = format!("`{}` has no record of `{code}`", folder.display());
        return Err(Failure::new(what, "look at the code again"));
    }
    Ok(paths)
}

/// Deletes all records of a code; returns their number.
pub(crate) fn forget(folder: &Path, code: &str) -> Result<usize, Failure> {
    let files = files(folder, code)?;
    for file in &files {
        fs::remove_file(file).map_err(|error| Failure::of_path("delete", file, &error, HELP))?;
    }
    Ok(files.len())
}

#[cfg(test)]
mod tests {
    use bica_test_data::process::Folder;

    use super::*;
    use crate::exercise::Reasons;

    #[test]
    fn a_record_is_reported_and_forgotten_and_others_stay() {
        let files = Folder::new("record");
        let folder = files.path();
        for code in ["K-27", "K-27", "K-2"] {
            let mut record = Record::begin(folder, code, "Arms <gentle>", vec![7, 9]).expect("a record");
            let right = Reasons::default();
            let (low, hidden) = (Reasons { too_low: true, ..right }, Reasons { not_seen: true, ..right });
            for (reasons, peak) in [(right, 98.0), (low, 70.0), (hidden, 90.0)] {
                record.note(3.0, (1, Attempt { reasons, peak, goal: 90.0 })).expect("a line");
            }
        }
        let page = report(folder, "K-27").expect("a page");
        assert_eq!(page.matches("<h2>Arms &lt;gentle&gt;").count(), 2, "{page}");
        assert_eq!(page.matches(" UTC</time>").count(), 2, "{page}");
        assert!(page.contains("1 correct, 1 not correct (too low), 1 not seen") && page.contains("Line 9"), "{page}");
        assert_eq!(forget(folder, "K-27").expect("two records"), 2);
        assert!(forget(folder, "K-27").is_err() && report(folder, "K-2").is_ok());
        assert!(Record::begin(folder, "Anna Maier", "", vec![]).is_err() && forget(folder, "../x").is_err());
    }
}
