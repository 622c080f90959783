//! A world that runs in this process.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::thread::JoinHandle;
use std::time::Duration;

use bica::runner::STACK_BYTES;
use bica_wire::model::Invalid;

use super::session::Session;
use super::storage;
use crate::files;
use crate::options::Options;
use crate::program::{Game, Program, WorldRun, WorldSetup};
use crate::protocol::Failed;

/// Interval of checks whether a starting world has ended.
const POLL: Duration = Duration::from_millis(50);

/// World and set-up.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setup {
    pub(super) world: String,
    pub(super) seed: u64,
    pub(super) options: BTreeMap<String, String>,
    /// Parameters that pages have changed, `Component.name`, with their values.
    pub(super) tuned: BTreeMap<String, String>,
}

/// A world that runs in its own thread.
pub(super) struct World {
    thread: Option<JoinHandle<Result<(), Invalid>>>,
    pub(super) run: WorldRun,
    /// Whether the file of its recording is kept at the end.
    is_kept: bool,
}

impl Setup {
    /// Prepares a restart, with another seed if given, and with the parameters that pages have changed.
    pub(super) fn again(&mut self, seed: Option<u64>, session: &Session) {
        self.seed = seed.unwrap_or(self.seed);
        self.tuned.extend(session.tuned());
    }

    /// Checks the set-up, and returns the function that runs it.
    pub(super) fn prepare(&self, program: &Program, options: &Options) -> Result<Game, Failed> {
        let world = program.world(&self.world)?;
        let tune = options.tune.join(format!("{}.toml", self.world));
        let tune = tune.exists().then_some(tune);
        if let Some(tune) = &tune {
            files::open(tune).map_err(|error| files::failed("read", tune, &error, "remove it"))?;
        }
        let set = self.tuned.iter().map(|(name, value)| format!("{name}={value}")).collect();
        let setup = WorldSetup { seed: self.seed, options: self.options.clone(), tune, set };
        Ok(world.prepare(&setup)?)
    }
}

impl World {
    /// Starts a world and waits until its link can be reached.
    pub(super) fn start(game: Game, options: &Options, recording: PathBuf) -> Result<Self, Failed> {
        // If the spool folder cannot be created, the recording cannot be created either, which the world reports.
        let _ = storage::make_private(&options.spool);
        let is_kept = !recording.starts_with(&options.spool);
        let run = WorldRun::new(recording);
        let own = run.clone();
        let thread = std::thread::Builder::new().name("world".to_owned()).stack_size(STACK_BYTES);
        let thread = thread.spawn(move || game(&own));
        let thread = thread.map_err(|error| Failed::new(error.to_string(), "close other programs"))?;
        let mut world = Self { thread: Some(thread), run, is_kept };
        while !world.run.memory().is_served_within(POLL) {
            if world.has_ended() {
                return Err(world
                    .ending()
                    .err()
                    .unwrap_or_else(|| Failed::new("the world ended at once", "try again")));
            }
        }
        Ok(world)
    }

    /// Returns whether the run has ended.
    pub(super) fn has_ended(&self) -> bool {
        self.thread.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// Waits for the end of the run; returns its error, if there is one.
    pub(super) fn ending(&mut self) -> Result<(), Failed> {
        let panicked = || Invalid::new("the world ended with a panic", "its message is in the terminal");
        let result = self.thread.take().map(JoinHandle::join);
        result.unwrap_or(Ok(Ok(()))).unwrap_or_else(|_| Err(panicked())).map_err(Failed::from)
    }
}

impl Drop for World {
    fn drop(&mut self) {
        self.run.end();
        // The error of an abandoned world is of no use.
        let _ = self.ending();
        if !self.is_kept {
            // The file may have been removed already.
            let _ = fs::remove_file(self.run.recording());
        }
    }
}
