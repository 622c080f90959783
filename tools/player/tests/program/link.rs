//! `player play --serve` and `player link`, as processes.

use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::Value;

use crate::process::{player, run};

/// A game in a process of its own that serves monitors.
struct Served {
    child: Child,
    stdout: BufReader<ChildStdout>,
    address: String,
}

impl Served {
    fn start(more: &[&str]) -> Self {
        let args = [&["play", "--serve", "127.0.0.1:0", "--seed", "3", "--size", "160x120"][..], more].concat();
        let mut child = player(&args).stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut line = String::new();
        let address = loop {
            line.clear();
            assert_ne!(stdout.read_line(&mut line).expect("UTF-8"), 0, "the game ended");
            if let Some((_, address)) = line.split_once("monitors attach at ") {
                break address.trim().to_owned();
            }
        };
        Self { child, stdout, address }
    }

    fn link(&self, args: &[&str]) -> Command {
        player(&[&["link", &self.address][..], args].concat())
    }

    /// Runs a monitor and returns its exit code and the lines of its output.
    fn monitor(&self, args: &[&str]) -> (Option<i32>, Vec<Value>, String) {
        let ran = run(&[&["link", &self.address, "--json"][..], args].concat());
        let lines = ran.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
        (ran.code, lines, ran.stderr)
    }

    /// Waits for the end of the game; returns the lines of its output.
    fn finish(mut self) -> Vec<String> {
        let lines = self.stdout.by_ref().lines().map(Result::unwrap).collect();
        self.child.wait().expect("it ends");
        lines
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
