//! A running JManager.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use crate::folder::{Folder, program};
use crate::robot::player;

/// Time limit of the start, for a busy machine.
const START: Duration = Duration::from_mins(1);
/// Time limit of the end, for a busy machine.
const END: Duration = Duration::from_secs(20);

/// A server that ends when this is dropped.
pub struct Server {
    child: Child,
    urls: Receiver<String>,
    /// Folder of its recordings and files.
    pub folder: Folder,
}

impl Server {
    /// Starts the program with further arguments, in its own folder.
    #[must_use]
    pub fn start(name: &str, arguments: &[&str]) -> Self {
        Self::start_program(&program("jmanager"), name, arguments)
    }

    /// Starts the program with a folder of sources.
    #[must_use]
    pub fn with_sources(name: &str, sources: &Folder) -> Self {
        Self::start(name, &["--source", &sources.argument("")])
    }

    /// Starts the monitor of an example.
    #[must_use]
    pub fn start_example(name: &str) -> Self {
        Self::start_program(&program("examples").join(name), name, &["monitor"])
    }

    /// Starts another program of the repository.
    #[must_use]
    pub fn start_other(name: &str, arguments: &[&str]) -> Self {
        Self::start_program(&program(name), name, arguments)
    }

    fn start_program(program: &Path, name: &str, arguments: &[&str]) -> Self {
        let folder = Folder::new(name);
        let mut child = Command::new(program)
            .args(arguments)
            .args(["--no-open", "--port", "0"])
            .current_dir(folder.path(""))
            .stdout(Stdio::piped())
            .spawn()
            .unwrap_or_else(|error| panic!("cannot start {}: {error}; build it first", program.display()));
        let output = child.stdout.take().expect("the output is a pipe");
        let (sender, urls) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if let Some(url) = line.split_whitespace().find(|word| word.starts_with("http://")) {
                    let _ = sender.send(url.to_owned());
                }
            }
        });
        Self { child, urls, folder }
    }

    /// Returns the URL that it printed; it works once.
    #[must_use]
    pub fn url(&self) -> String {
        self.urls.recv_timeout(START).expect("the server prints a URL")
    }

    /// Plays a game with more arguments of `player play`, and records it in the server's folder of recordings.
    pub fn record(&self, name: &str, arguments: &[&str]) {
        std::fs::create_dir_all(self.folder.path("recordings")).expect("a folder");
        let file = self.folder.argument(&format!("recordings/{name}.mcap"));
        player(&[&["play", "--record", &file], arguments].concat());
    }

    /// Returns its processor time, s.
    #[must_use]
    pub fn processor_seconds(&self) -> f64 {
        processor_seconds(self.child.id())
    }

    /// Returns its resident memory, bytes.
    #[must_use]
    pub fn resident_bytes(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).expect("the server runs");
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).expect("the resident set");
        line.trim().trim_end_matches(" kB").parse::<u64>().expect("a number") * 1024
    }

    /// Stops the process until [`resume`](Self::resume); it answers nothing meanwhile.
    pub fn pause(&self) {
        self.signal("-STOP");
    }

    /// Continues the process.
    pub fn resume(&self) {
        self.signal("-CONT");
    }

    fn signal(&self, signal: &str) {
        let status = Command::new("kill").args([signal, &self.child.id().to_string()]).status().expect("kill runs");
        assert!(status.success(), "kill {signal}: {status}");
    }

    /// Ends it at once, as a crash would.
    pub fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // As Ctrl-C does: the server ends the programs that it has started.
        let _ = Command::new("kill").args(["-INT", &self.child.id().to_string()]).stderr(Stdio::null()).status();
        let begin = Instant::now();
        while begin.elapsed() < END && matches!(self.child.try_wait(), Ok(None)) {
            std::thread::sleep(Duration::from_millis(20));
        }
        self.kill();
    }
}

/// Returns the processor time of a process, s.
#[must_use]
pub fn processor_seconds(process: u32) -> f64 {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).expect("the process runs");
    let (_, after_name) = stat.rsplit_once(')').expect("a name in brackets");
    // Of the fields after the name, the 12th and 13th are user and system time, in hundredths of a second.
    let ticks = after_name.split_whitespace().skip(11).take(2).map(|ticks| ticks.parse::<f64>().expect("a number"));
    ticks.sum::<f64>() / 100.0
}
