//! Processes of the examples.

use std::env;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Output, Stdio};

use serde_json::Value;

/// Returns the program of an example, which `cargo test -p bica-app` builds.
pub(crate) fn example(name: &str) -> Command {
    let test = env::current_exe().expect("the path of this test");
    let built = test.parent().and_then(Path::parent).expect("the folder of the profile").join("examples");
    let program = built.join(name).with_extension(env::consts::EXE_EXTENSION);
    assert!(program.exists(), "{} is missing: run `cargo build -p bica-app --examples`", program.display());
    let mut command = Command::new(program);
    command.stdin(Stdio::null());
    command
}

/// Result of a process.
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// Runs a program to its end.
pub(crate) fn finish(mut program: Command) -> Ran {
    let Output { status, stdout, stderr } = program.output().expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Ran { code: status.code(), stdout: text(stdout), stderr: text(stderr) }
}

/// Runs the wall follower to its end.
pub(crate) fn run(args: &[&str]) -> Ran {
    let mut program = example("wall_follower");
    program.args(args);
    finish(program)
}

/// Runs the wall follower, which must end with exit code 2 and these words on stderr.
pub(crate) fn refused(args: &[&str], words: &[&str]) {
    let ran = run(args);
    assert_eq!((ran.code, &*ran.stdout), (Some(2), ""), "{args:?}: {}", ran.stderr);
    for word in words {
        assert!(ran.stderr.contains(word), "{args:?} lacks `{word}`:\n{}", ran.stderr);
    }
}

impl Ran {
    /// Parses the output, which must be one JSON value.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error} in:\n{}{}", self.stdout, self.stderr))
    }
}

/// A run that serves monitors.
pub(crate) struct Served {
    pub(crate) child: Child,
    pub(crate) stdout: BufReader<ChildStdout>,
    pub(crate) address: String,
}

impl Served {
    /// Starts a program that serves monitors.
    pub(crate) fn start(mut program: Command) -> Self {
        let mut child = program.stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut line = String::new();
        stdout.read_line(&mut line).expect("UTF-8");
        let address = line.split_once("monitors attach at ").unwrap_or_else(|| panic!("no address in `{line}`")).1;
        Self { child, stdout, address: address.trim().to_owned() }
    }

    /// Runs a monitor of the wall follower to its end, which must be a success; returns the lines of its output.
    pub(crate) fn link(&self, args: &[&str]) -> Vec<Value> {
        let ran = run(&[&["link", &self.address, "--json"][..], args].concat());
        assert_eq!(ran.code, Some(0), "{args:?}: {}", ran.stderr);
        ran.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Empty folder of a test, removed at its end.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    /// Returns the path of a file in it.
    pub(crate) fn file(&self, name: &str) -> String {
        self.0.join(name).into_os_string().into_string().expect("UTF-8")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
