//! The program that is built from the sources and run.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use super::cargo::{Workspace, cargo, progress};
use super::files::Files;
use super::process::{self, Group, LastLines};
use crate::pages::lock;
use crate::protocol::{Build, BuildState, CodeMessage, Failed, SessionId, ToPage};

/// Longest time from the start of a program until it prints its address.
const START: Duration = Duration::from_mins(2);

/// Opens and closes sessions.
pub(crate) trait Host: Send + Sync {
    /// Opens a session of the robot at an address. It replaces the session `replaced`, and takes over its breakpoints.
    ///
    /// # Errors
    /// If there are too many sessions.
    fn open(&self, address: &str, replaced: Option<SessionId>) -> Result<SessionId, Failed>;

    /// Closes a session; does nothing if it is closed already.
    fn close(&self, session: SessionId);
}

/// The running program, and the one that is being built.
pub(super) struct Runs {
    files: Arc<Files>,
    host: Arc<dyn Host>,
    /// Arguments of Cargo, and of the program.
    arguments: (Vec<String>, Vec<String>),
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    /// Number of the last request.
    request: u64,
    building: Option<Group>,
    /// The running program, and the request that has started it.
    program: Option<(u64, Group)>,
    session: Option<SessionId>,
    last: Option<Build>,
}

/// Values for the arguments of a program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules {
    pub(super) seed: u64,
    pub(super) robots: usize,
}

impl Runs {
    /// Creates the runs of a program: `template` is `[CARGO-OPTIONS] -- [ARGUMENTS]`.
    pub(super) fn new(files: Arc<Files>, host: Arc<dyn Host>, template: &str) -> Self {
        let words: Vec<String> = template.split_whitespace().map(str::to_owned).collect();
        let end = words.iter().position(|word| word == "--").unwrap_or(words.len());
        let program = words.get(end + 1..).unwrap_or_default().to_vec();
        Self { files, host, arguments: (words[..end].to_vec(), program), state: Mutex::default() }
    }

    /// Returns the last message about the program.
    pub(super) fn last(&self) -> Option<Build> {
        lock(&self.state).last.clone()
    }

    /// Builds and runs the program in a new thread. A running build is cancelled. The running program continues until the new one
    /// has started.
    pub(super) fn start(self: &Arc<Self>, rules: Rules) -> Result<(), Failed> {
        let request = self.next_request();
        let own = Arc::clone(self);
        let spawned = thread::Builder::new().name("run".to_owned()).spawn(move || own.work(request, rules));
        spawned.map(drop).map_err(|error| Failed::new(error.to_string(), "close other programs"))
    }

    fn next_request(&self) -> u64 {
        let mut state = lock(&self.state);
        state.request += 1;
        if let Some(group) = state.building.take() {
            group.kill();
        }
        state.request
    }

    /// Ends the build and the running program.
    pub(super) fn stop(&self) {
        self.next_request();
        let (program, session) = {
            let mut state = lock(&self.state);
            (state.program.take(), state.session.take())
        };
        if let Some((_, group)) = program {
            group.kill();
        }
        if let Some(session) = session {
            self.host.close(session);
        }
        if self.last().is_some() {
            self.say(None, BuildState::Ended, (0, 0), "stopped", Vec::new());
        }
    }

    /// Sends a message to all pages, unless there is a newer request.
    fn say(
        &self,
        request: Option<u64>,
        state: BuildState,
        (done, total): (u32, u32),
        text: &str,
        messages: Vec<CodeMessage>,
    ) {
        let mut own = lock(&self.state);
        if request.is_some_and(|request| request != own.request) {
            return;
        }
        let build = Build { state, done, total, text: text.to_owned(), session: own.session, messages };
        own.last = Some(build.clone());
        drop(own);
        self.files.pages.broadcast(&ToPage::Build(build));
    }

    fn work(&self, request: u64, rules: Rules) {
        self.say(Some(request), BuildState::Building, (0, 0), "building", Vec::new());
        let mut messages = Vec::new();
        let result = self.build(request, &mut messages);
        let result = result.and_then(|(root, program)| self.run(request, rules, (&root, &program), &messages));
        if let Err(failed) = result {
            self.say(Some(request), BuildState::Failed, (0, 0), &format!("{}\n{}", failed.text, failed.help), messages);
        }
    }

    /// Builds the program; returns the root of the workspace, and the program's path.
    fn build(&self, request: u64, messages: &mut Vec<CodeMessage>) -> Result<(PathBuf, PathBuf), Failed> {
        let workspace = Workspace::of(self.files.folder.root())?;
        let versions = self.files.versions();
        let mut command = cargo(&workspace.root);
        command.args(["build", "--release", "--message-format=json", "--target-dir"]).arg(&workspace.target);
        command
            .args(&self.arguments.0)
            .env("CARGO_TERM_PROGRESS_WHEN", "always")
            .env("CARGO_TERM_PROGRESS_WIDTH", "100");
        let (mut child, group) = start(&mut command, "cargo")?;
        self.register(request, group);
        let (send_errors, errors) = channel();
        if let Some(stream) = child.stderr.take() {
            process::send_lines(stream, send_errors);
        }
        let (send_lines, lines) = channel();
        if let Some(stream) = child.stdout.take() {
            process::send_lines(stream, send_lines);
        }
        let (mut last, mut program, mut done) = (LastLines::default(), None, (0, 0));
        loop {
            match errors.recv_timeout(Duration::from_millis(100)) {
                Ok(line) => match progress(&line) {
                    Some(now) if now != done => {
                        done = now;
                        self.say(Some(request), BuildState::Building, done, line.trim(), Vec::new());
                    }
                    Some(_) => {}
                    None => last.add(line),
                },
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        for line in lines {
            let Ok(line) = serde_json::from_str::<Value>(&line) else { continue };
            self.files.add_message(&line, &workspace.root, &versions, messages);
            if let Some(path) = line["executable"].as_str() {
                program = Some(PathBuf::from(path));
            }
        }
        let current = self.unregister(group);
        let status = child.wait().map_err(|error| Failed::new(error.to_string(), "try again"))?;
        match program {
            _ if !current || lock(&self.state).request != request => {
                Err(Failed::new("given up", "another one was asked for"))
            }
            Some(program) if status.success() => Ok((workspace.root, program)),
            None if status.success() => {
                Err(Failed::new("the build makes no program", "name one with `--bin` or `--example` in --run"))
            }
            _ => Err(Failed::new(last.text(), "mend the errors, then run again")),
        }
    }

    fn register(&self, request: u64, group: Group) {
        let mut state = lock(&self.state);
        if state.request == request {
            state.building = Some(group);
        } else {
            group.kill();
        }
    }

    /// Removes a process group; returns whether it belonged to the last request.
    fn unregister(&self, group: Group) -> bool {
        let mut state = lock(&self.state);
        state.building.take_if(|building| *building == group).is_some()
    }

    /// Starts the program, opens its session, and waits until it ends.
    fn run(
        &self,
        request: u64,
        rules: Rules,
        (root, program): (&Path, &Path),
        messages: &[CodeMessage],
    ) -> Result<(), Failed> {
        self.say(Some(request), BuildState::Starting, (0, 0), "the program starts", messages.to_vec());
        let mut command = Command::new(program);
        command.current_dir(root).args(self.arguments.1.iter().map(|word| filled(word, rules)));
        let (mut child, group) = start(&mut command, "the program")?;
        self.register(request, group);
        let (sender, lines) = channel();
        if let Some(stream) = child.stdout.take() {
            process::send_lines(stream, sender.clone());
        }
        if let Some(stream) = child.stderr.take() {
            process::send_lines(stream, sender.clone());
        }
        drop(sender);
        let (mut last, until) = (LastLines::default(), Instant::now() + START);
        let mut address = None;
        while address.is_none() {
            match lines.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(line) => {
                    address = address_of(&line);
                    last.add(line);
                }
                Err(_) => break,
            }
        }
        let current = self.unregister(group);
        let Some(address) = address.filter(|_| current) else {
            group.kill();
            // The exit status of a killed program is of no interest.
            let _ = child.wait();
            let what = format!("the program did not print the address of its link:\n{}", last.text());
            return Err(Failed::new(
                what,
                "a program that is run prints `127.0.0.1:PORT`, as the programs of robots do with `--serve ADDR`",
            ));
        };
        self.replace(request, group, &address)?;
        self.say(Some(request), BuildState::Running, (0, 0), &format!("it runs, link at {address}"), messages.to_vec());
        for line in lines {
            last.add(line);
        }
        lock(&self.state).program.take_if(|(_, running)| *running == group);
        let ended = child.wait().map_or_else(|error| error.to_string(), |status| status.to_string());
        self.say(
            Some(request),
            BuildState::Ended,
            (0, 0),
            &format!("the program has ended, {ended}\n{}", last.text()),
            Vec::new(),
        );
        Ok(())
    }

    /// Ends the previous program, and opens a session of the new one.
    fn replace(&self, request: u64, group: Group, address: &SocketAddr) -> Result<(), Failed> {
        let (program, session) = {
            let mut state = lock(&self.state);
            if state.request != request {
                group.kill();
                return Err(Failed::new("given up", "another one was asked for"));
            }
            (state.program.replace((request, group)), state.session.take())
        };
        if let Some((_, group)) = program {
            group.kill();
        }
        let session = self.host.open(&format!("tcp://{address}"), session).inspect_err(|_| group.kill())?;
        lock(&self.state).session = Some(session);
        Ok(())
    }
}

fn start(command: &mut Command, what: &str) -> Result<(std::process::Child, Group), Failed> {
    let failed = |error| Failed::new(format!("{what} cannot be started: {error}"), "is it installed?");
    process::start(command).map_err(failed)
}

/// Returns a word of the program's arguments with its placeholders replaced.
fn filled(word: &str, rules: Rules) -> String {
    let Rules { seed, robots } = rules;
    word.replace("{address}", "127.0.0.1:0")
        .replace("{seed}", &seed.to_string())
        .replace("{robots}", &robots.to_string())
}

/// Returns the loopback address in a line that a program prints.
fn address_of(line: &str) -> Option<SocketAddr> {
    let word = |word: &str| word.trim_start_matches("tcp://").trim_end_matches(['.', ',', ';', '/']).parse().ok();
    line.split_whitespace()
        .find_map(word)
        .filter(|address: &SocketAddr| address.ip().is_loopback() && address.port() != 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_is_found_in_what_the_program_prints() {
        let expected = Some("127.0.0.1:4711".parse().unwrap());
        assert_eq!(address_of("link          monitors attach at 127.0.0.1:4711"), expected);
        assert_eq!(address_of("tcp://127.0.0.1:4711/"), expected);
        for other in ["", "at 10.0.0.1:4711", "127.0.0.1", "127.0.0.1:0"] {
            assert_eq!(address_of(other), None, "{other}");
        }
    }

    #[test]
    fn arguments_get_their_values() {
        let rules = Rules { seed: 7, robots: 2 };
        assert_eq!(filled("--seed={seed}", rules), "--seed=7");
        assert_eq!(filled("{address}", rules), "127.0.0.1:0");
        assert_eq!(filled("{robots}", rules), "2");
    }
}
