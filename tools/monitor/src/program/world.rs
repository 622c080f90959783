//! Worlds that a program can simulate in its own process.

use std::collections::{BTreeMap, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use crate::pages::lock;
use crate::protocol::WorldOption;
use bica_link::{Address, Memory};
use bica_wire::model::Invalid;

/// A world that a program can simulate in its own process.
///
/// The monitor attaches to it over a link, as to any robot: pages see it and control its time over that link.
pub trait LocalWorld: Send + Sync {
    /// Name by which it is opened, such as `built-in`.
    fn name(&self) -> &str;

    /// Options besides the seed that the page offers. The world may accept more.
    fn options(&self) -> Vec<WorldOption> {
        Vec::new()
    }

    /// Checks a set-up, and returns the function that runs it.
    ///
    /// # Errors
    /// If the world cannot be run with this set-up.
    fn prepare(&self, setup: &WorldSetup) -> Result<Game, Invalid>;
}

/// Function that runs a world in its own thread. It serves a link at [`WorldRun::address`], whose offers contain
/// [`PAUSE`](bica_wire::message::Offers::PAUSE), until [`WorldRun::is_ended`]. Its time follows the clock.
pub type Game = Box<dyn FnOnce(&WorldRun) -> Result<(), Invalid> + Send>;

/// Set-up of a world.
#[derive(Clone, Debug, Default)]
pub struct WorldSetup {
    /// Seed.
    pub seed: u64,
    /// Values of options by name, as text. The world checks them.
    pub options: BTreeMap<String, String>,
    /// File with parameters of this world, if there is one.
    pub tune: Option<PathBuf>,
    /// Parameters `Component.name=value` that override that file: those that pages changed before the world was restarted.
    pub set: Vec<String>,
}

/// A run of a world, shared by the world and its session. Clones refer to the same run.
#[derive(Clone, Debug)]
pub struct WorldRun(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    memory: Memory,
    recording: PathBuf,
    state: Mutex<State>,
}

#[derive(Debug, Default)]
struct State {
    is_ended: bool,
    is_over: bool,
    notes: VecDeque<String>,
    not_recorded: Option<String>,
}

impl WorldRun {
    pub(crate) fn new(recording: PathBuf) -> Self {
        Self(Arc::new(Shared { memory: Memory::default(), recording, state: Mutex::default() }))
    }

    pub(crate) fn memory(&self) -> &Memory {
        &self.0.memory
    }

    /// Address of the link.
    #[must_use]
    pub fn address(&self) -> Address {
        Address::Memory(self.0.memory.clone())
    }

    /// File in which the run is recorded; an older one is replaced.
    #[must_use]
    pub fn recording(&self) -> &Path {
        &self.0.recording
    }

    /// Returns whether the world must end.
    #[must_use]
    pub fn is_ended(&self) -> bool {
        lock(&self.0.state).is_ended
    }

    /// Returns whether the rules of the world have ended the run. The world then [pauses](bica_link::LinkRequests::pause).
    #[must_use]
    pub fn is_over(&self) -> bool {
        lock(&self.0.state).is_over
    }

    /// Marks the run as ended by the rules of the world; it can be continued. Returns whether it was not marked before.
    #[must_use]
    pub fn over(&self) -> bool {
        !std::mem::replace(&mut lock(&self.0.state).is_over, true)
    }

    /// Returns the next note of a person, for the recording; none if there is no new one.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        lock(&self.0.state).notes.pop_front()
    }

    /// Reports why the run is not recorded, or no longer recorded.
    pub fn not_recorded(&self, reason: &str) {
        lock(&self.0.state).not_recorded = Some(reason.to_owned());
    }

    pub(crate) fn end(&self) {
        lock(&self.0.state).is_ended = true;
    }

    pub(crate) fn add_note(&self, text: &str) {
        lock(&self.0.state).notes.push_back(text.to_owned());
    }

    /// Returns why the recording ended before the run; none if it did not.
    pub(crate) fn recording_ended(&self) -> Option<String> {
        lock(&self.0.state).not_recorded.clone()
    }
}
