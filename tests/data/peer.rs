//! Comparison of our encoding of messages with that of a peer in Python.
//!
//! A script prints random messages as lines `KIND<tab>ENCODING<tab>VALUES`, with the encoding in hexadecimal, and compares such lines.

use std::env;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// Numbers of random messages: where the package happens to be installed, and in CI.
const MESSAGES: [usize; 2] = [500, 10_000];

/// A script of a peer, and the Python that runs it.
pub struct Peer {
    python: String,
    script: &'static str,
    count: String,
}

impl Peer {
    /// The peer if its package is there. The variable `BICA_PEERS` names a Python that must have it; CI sets it.
    ///
    /// # Panics
    /// If that Python does not have the package.
    #[must_use]
    pub fn find(package: &str, script: &'static str) -> Option<Self> {
        let required = env::var("BICA_PEERS");
        let python = required.clone().unwrap_or_else(|_| "python3".to_owned());
        let found = Command::new(&python).args(["-c", &format!("import {package}")]).output();
        if found.is_ok_and(|output| output.status.success()) {
            let count = MESSAGES[usize::from(required.is_ok())].to_string();
            return Some(Self { python, script, count });
        }
        assert!(required.is_err(), "{python} has no package `{package}`");
        eprintln!("skipped: python3 with {package} is not installed");
        None
    }

    /// Reads random messages of the peer, and lets it compare what `ours` makes of them: kind, encoding and values of each message give
    /// our encoding and values.
    ///
    /// # Panics
    /// If the peer finds a difference, or has not compared all messages.
    pub fn compare(&self, ours: impl Fn(&str, &[u8], &str) -> (Vec<u8>, String)) {
        let mut ask = Command::new(&self.python);
        let random = ask.args([self.script, "random", &self.count, "7"]).output().expect("it runs");
        assert!(random.status.success(), "{}", String::from_utf8_lossy(&random.stderr));
        let mut lines = String::new();
        for line in String::from_utf8(random.stdout).expect("text").lines() {
            let [kind, encoded, values] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line}") };
            let byte = |at| u8::from_str_radix(&encoded[at..at + 2], 16).expect("hexadecimal");
            let bytes: Vec<_> = (0..encoded.len()).step_by(2).map(byte).collect();
            let (bytes, values) = ours(kind, &bytes, values);
            let encoded = bytes.iter().fold(String::new(), |mut text, byte| {
                write!(text, "{byte:02x}").expect("a String takes all");
                text
            });
            lines.extend([kind, "\t", &encoded, "\t", &values, "\n"]);
        }
        let mut check = Command::new(&self.python);
        check.args([self.script, "check"]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut check = check.spawn().expect("it runs");
        check.stdin.take().expect("an input").write_all(lines.as_bytes()).expect("it reads");
        let output = check.wait_with_output().expect("it ends");
        assert!(output.status.success(), "the peer reads other values");
        assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), self.count);
    }
}
