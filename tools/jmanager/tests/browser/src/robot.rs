//! Other programs that a story needs: a robot behind a link, and games.

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::Value;

use crate::folder::{program, repository};

/// A simulated robot in its own process, which ends when this is dropped.
pub struct Robot {
    child: Child,
    output: ChildStdout,
    /// Its address: `HOST:PORT`.
    pub address: String,
}

impl Robot {
    /// Starts a game in real time with more arguments of `player play`.
    #[must_use]
    pub fn start(arguments: &[&str]) -> Self {
        Self::start_at("127.0.0.1:0", arguments)
    }

    /// Starts it at an address.
    #[must_use]
    pub fn start_at(address: &str, arguments: &[&str]) -> Self {
        let mut child = command(&[&["play", "--realtime", "--json", "--serve", address], arguments].concat())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program `player` is built");
        let mut lines = BufReader::new(child.stderr.take().expect("a pipe")).lines().map_while(Result::ok);
        let address = lines
            .find_map(|line| Some(line.split_once("monitors attach at ")?.1.trim().to_owned()))
            .expect("the program prints the address of its link");
        // The rest is read, so that a full pipe never blocks the program.
        std::thread::spawn(move || lines.for_each(drop));
        let output = child.stdout.take().expect("a pipe");
        Self { child, output, address }
    }

    /// Restricts it to one processor.
    #[must_use]
    pub fn on_processor(self, processor: usize) -> Self {
        restrict_to(self.child.id(), &processor.to_string());
        self
    }

    /// Waits for the end of the game; returns the 99th percentile of the duration of a cycle, ms.
    #[must_use]
    pub fn latency(mut self) -> f64 {
        let mut text = String::new();
        self.output.read_to_string(&mut text).expect("the summary of the game");
        let summary: Value = serde_json::from_str(&text).expect("a JSON object");
        summary["wall"]["latency_ms"]["p99"].as_f64().expect("a latency")
    }

    /// Ends it at once, as a crash would.
    pub fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Robot {
    fn drop(&mut self) {
        self.kill();
    }
}

/// A program `player referee`, which ends when this is dropped.
pub struct Referee(Child);

impl Referee {
    /// Starts it with more arguments.
    #[must_use]
    pub fn start(arguments: &[&str]) -> Self {
        let mut command = command(&[&["referee"], arguments].concat());
        Self(command.stdin(Stdio::null()).stdout(Stdio::null()).spawn().expect("the program `player` is built"))
    }
}

impl Drop for Referee {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Restricts the threads of a process, and those that it starts later, to processors: `0` or `0-1`.
pub fn restrict_to(process: u32, processors: &str) {
    let status =
        Command::new("taskset").args(["-acp", processors, &process.to_string()]).stdout(Stdio::null()).status();
    assert!(status.expect("`taskset` of util-linux").success(), "taskset {processors}");
}

/// Runs `player` to its end.
pub fn player(arguments: &[&str]) {
    let status = command(arguments).stdout(Stdio::null()).status().expect("the program `player` is built");
    // 1: a game without a goal.
    assert!(matches!(status.code(), Some(0 | 1)), "player {arguments:?}: {status}");
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(program("player"));
    command.args(arguments).current_dir(repository(""));
    command
}
