//! Helpers for tests that run programs, and folders for their files.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

use serde_json::Value;

/// Result of a program that has ended.
pub struct Ran {
    /// Exit code; `None` after a signal.
    pub code: Option<i32>,
    /// Text that the program wrote to stdout.
    pub stdout: String,
    /// Text that the program wrote to stderr.
    pub stderr: String,
}

impl Ran {
    /// Runs a program to its end, without input.
    ///
    /// # Panics
    /// If the program does not start, or its output is not UTF-8.
    #[must_use]
    pub fn of(mut program: Command) -> Self {
        let Output { status, stdout, stderr } = program.stdin(Stdio::null()).output().expect("the program starts");
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        Self { code: status.code(), stdout: text(stdout), stderr: text(stderr) }
    }

    /// Parses stdout, which must be one JSON value.
    ///
    /// # Panics
    /// If it is not.
    #[must_use]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error} in:\n{}{}", self.stdout, self.stderr))
    }

    /// Parses stdout, in which each line must be a JSON value.
    ///
    /// # Panics
    /// If a line is not.
    #[must_use]
    pub fn lines(&self) -> Vec<Value> {
        self.stdout.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect()
    }

    /// Checks that the program ended with exit code 2 and with these words on stderr.
    ///
    /// # Panics
    /// If it did not.
    pub fn refused(&self, words: &[&str]) {
        assert_eq!(self.code, Some(2), "{}{}", self.stdout, self.stderr);
        for word in words {
            assert!(self.stderr.contains(word), "`{word}` is missing in:\n{}", self.stderr);
        }
    }
}

/// Program that serves monitors. Dropping the value ends it.
pub struct Served {
    /// The process.
    pub child: Child,
    /// Output of the program after the line with the address.
    pub stdout: BufReader<ChildStdout>,
    /// Address at which monitors attach.
    pub address: String,
}

impl Served {
    /// Starts a program, and waits for its address.
    ///
    /// # Panics
    /// If the program ends before it has printed an address.
    #[must_use]
    pub fn start(mut program: Command) -> Self {
        let mut child = program.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut lines = stdout.by_ref().lines().map_while(Result::ok);
        let address = lines.find_map(|line| Some(line.split_once("monitors attach at ")?.1.trim().to_owned()));
        Self { child, stdout, address: address.expect("the program prints an address") }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Empty folder of a test; it is removed when the value is dropped.
pub struct Folder(
    /// Path of the folder.
    pub PathBuf,
);

impl Folder {
    /// Creates a folder whose name contains `name`.
    ///
    /// # Panics
    /// If the folder cannot be created.
    #[must_use]
    pub fn new(name: &str) -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("bica-test-{}-{number}-{}", std::process::id(), name.replace('/', "-"));
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    /// Path of the folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Path of the folder, as text.
    ///
    /// # Panics
    /// If the path is not UTF-8.
    #[must_use]
    pub fn text(&self) -> &str {
        self.0.to_str().expect("UTF-8")
    }

    /// Path of a file in the folder.
    ///
    /// # Panics
    /// If the path is not UTF-8.
    #[must_use]
    pub fn file(&self, name: &str) -> String {
        self.0.join(name).into_os_string().into_string().expect("UTF-8")
    }

    /// Names of the files in the folder, sorted.
    ///
    /// # Panics
    /// If the folder cannot be read, or a name is not UTF-8.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = entries.map(|name| name.into_string().expect("UTF-8")).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
