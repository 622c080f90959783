//! A running JManager.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Longest start on a busy machine.
const START: Duration = Duration::from_mins(1);
/// Longest end on a busy machine.
const END: Duration = Duration::from_secs(20);

/// A server that ends when this is dropped.
pub struct Server {
    child: Child,
    urls: Receiver<String>,
    /// Folder of its recordings and files.
    pub folder: PathBuf,
}

impl Server {
    /// Starts the program with more arguments, in a folder of its own.
    ///
    /// # Panics
    /// If the program is not built or does not start.
    #[must_use]
    pub fn start(name: &str, arguments: &[&str]) -> Self {
        Self::start_program(&program("jmanager"), name, arguments)
    }

    /// The same with the monitor of an example.
    ///
    /// # Panics
    /// If the example is not built or does not start.
    #[must_use]
    pub fn start_example(name: &str) -> Self {
        Self::start_program(&program("examples").join(name), name, &["monitor"])
    }

    /// The same with another program of the repository.
    ///
    /// # Panics
    /// If the program is not built or does not start.
    #[must_use]
    pub fn start_other(name: &str, arguments: &[&str]) -> Self {
        Self::start_program(&program(name), name, arguments)
    }

    fn start_program(program: &Path, name: &str, arguments: &[&str]) -> Self {
        let folder = target().join(format!("browser/run/{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder for the server");
        let mut child = Command::new(program)
            .args(arguments)
            .args(["--no-open", "--port", "0"])
            .current_dir(&folder)
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

    /// The URL that it printed; it works once.
    ///
    /// # Panics
    /// If it prints none in time.
    #[must_use]
    pub fn url(&self) -> String {
        self.urls.recv_timeout(START).expect("the server prints a URL")
    }

    /// Time that the processor has worked for it, s.
    ///
    /// # Panics
    /// If it has ended.
    #[must_use]
    pub fn processor_seconds(&self) -> f64 {
        processor_seconds(self.child.id())
    }

    /// Memory that it has, bytes.
    ///
    /// # Panics
    /// If it has ended.
    #[must_use]
    pub fn resident_bytes(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).expect("the server runs");
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).expect("the resident set");
        line.trim().trim_end_matches(" kB").parse::<u64>().expect("a number") * 1024
    }

    /// Lets it stand still: it answers nothing until [`resume`](Self::resume).
    ///
    /// # Panics
    /// If it has ended.
    pub fn pause(&self) {
        self.signal("-STOP");
    }

    /// Lets it go on.
    ///
    /// # Panics
    /// If it has ended.
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
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Time that the processor has worked for a process, s.
///
/// # Panics
/// If it has ended.
#[must_use]
pub fn processor_seconds(process: u32) -> f64 {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).expect("the process runs");
    let (_, after_name) = stat.rsplit_once(')').expect("a name in brackets");
    // Of the fields after the name, the 12th and 13th are user and system time, in hundredths of a second.
    let ticks = after_name.split_whitespace().skip(11).take(2).map(|ticks| ticks.parse::<f64>().expect("a number"));
    ticks.sum::<f64>() / 100.0
}

/// A program of the repository, built in the profile that `JMANAGER_PROFILE` names, else `debug`.
pub(crate) fn program(name: &str) -> PathBuf {
    let profile = std::env::var("JMANAGER_PROFILE").unwrap_or_else(|_| "debug".to_owned());
    target().join(profile).join(name)
}

/// The folder `target` of the repository.
#[must_use]
pub fn target() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../../target"))
}
