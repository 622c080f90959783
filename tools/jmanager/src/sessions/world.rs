//! Worlds that are played in this process.

mod pacer;
mod stops;

use std::cell::Cell;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::JoinHandle;
use std::time::Duration;

use bica_console::Failure;
use bica_game::{FirmwareImage, GRAPH, RecordOptions, Rules, ServeOptions, WorldKind, play_controlled, settings};
use bica_link::Address;
use bica_recording::ImagePolicy;
use bica_sim::setup::Frame;
use bica_tuning::Layers;

use super::{files, storage};
use crate::options::Options;
use crate::protocol::Failed;

pub(super) use pacer::Pacer;

/// Worlds that this program can simulate.
pub(super) const WORLDS: &[&str] =
    if cfg!(feature = "mujoco") { &["built-in", "mujoco", "firmware"] } else { &["built-in", "firmware"] };

/// Kind and set-up of a world.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setup {
    /// `built-in`, `mujoco` or `firmware`.
    pub(super) world: String,
    pub(super) seed: u64,
    pub(super) robots: usize,
}

/// A world that is played by a thread of its own.
pub(super) struct World {
    thread: Option<JoinHandle<Result<(), Failure>>>,
    pacer: Arc<Pacer>,
    /// Address of its link.
    pub(super) address: Address,
    /// File with the recording of the whole run.
    recording: PathBuf,
    /// Whether the file stays.
    is_kept: bool,
}

fn kind(world: &str) -> Result<WorldKind, Failed> {
    match world {
        "built-in" | "firmware" => Ok(WorldKind::BuiltIn),
        #[cfg(feature = "mujoco")]
        "mujoco" => Ok(WorldKind::Mujoco),
        #[cfg(not(feature = "mujoco"))]
        "mujoco" => Err(Failed::new(
            "this program was built without MuJoCo",
            "install its library with `cargo xtask mujoco`, then build with `--features mujoco`",
        )),
        _ => Err(Failed::new(format!("there is no world `{world}`"), format!("known are {}", WORLDS.join(", ")))),
    }
}

impl Setup {
    /// Returns the rules of its game: without end, in real time.
    pub(super) fn rules(&self, options: &Options) -> Result<Rules, Failed> {
        let size = if self.world == "firmware" { Frame::Small } else { options.size };
        let firmware = (self.world == "firmware").then(|| FirmwareImage::new(options.firmware.clone(), size));
        let mut layers = Layers::new(&GRAPH);
        let tune = options.tune.join(format!("{}.toml", self.world));
        if tune.exists() {
            files::open(&tune).map_err(|error| storage::failed("read", &tune, &error, "remove it"))?;
            layers.read(&tune)?;
        }
        Ok(Rules {
            world: kind(&self.world)?,
            seed: self.seed,
            size,
            robots: self.robots,
            limit: Duration::MAX,
            realtime: true,
            firmware: firmware.transpose()?,
            settings: settings(&layers)?,
        })
    }
}

impl World {
    /// Starts a world and waits until its link can be reached.
    pub(super) fn start(
        setup: &Setup,
        options: &Options,
        recording: PathBuf,
        pacer: &Arc<Pacer>,
    ) -> Result<Self, Failed> {
        let rules = setup.rules(options)?;
        pacer.begin();
        // A spool folder that cannot be made is a recording that cannot be made, which the game reports.
        let _ = storage::make_private(&options.spool);
        let (ready, started) = sync_channel(1);
        let (own, path) = (Arc::clone(pacer), recording.clone());
        let is_kept = !recording.starts_with(&options.spool);
        let work = move || play(&rules, &own, &path, &ready);
        let thread = std::thread::Builder::new().name("world".to_owned()).spawn(work);
        let thread = thread.map_err(|error| Failed::new(error.to_string(), "close other programs"))?;
        let mut world = Self {
            thread: Some(thread),
            pacer: Arc::clone(pacer),
            address: Address::Tcp(String::new()),
            recording,
            is_kept,
        };
        match started.recv() {
            Ok(address) => world.address = Address::Tcp(address),
            Err(_) => return Err(world.ending().err().unwrap_or_else(|| Failed::new("the world ended at once", ""))),
        }
        Ok(world)
    }

    /// Whether the game has ended.
    pub(super) fn has_ended(&self) -> bool {
        self.thread.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// Waits for the end of the game; returns why it ended.
    pub(super) fn ending(&mut self) -> Result<(), Failed> {
        let panicked = || Failure::new("the world ended with a panic", "its message is in the terminal");
        let result = self.thread.take().map(JoinHandle::join);
        result.unwrap_or(Ok(Ok(()))).unwrap_or_else(|_| Err(panicked())).map_err(Failed::from)
    }
}

impl Drop for World {
    fn drop(&mut self) {
        self.pacer.end();
        // The failure of a world that is given up is of no use.
        let _ = self.ending();
        if !self.is_kept {
            // A file that is gone already needs no removal.
            let _ = fs::remove_file(&self.recording);
        }
    }
}

/// Plays a game until the pacer ends it.
fn play(
    rules: &Rules,
    pacer: &Arc<Pacer>,
    recording: &std::path::Path,
    ready: &SyncSender<String>,
) -> Result<(), Failure> {
    let has_begun = Cell::new(false);
    let started = |address: &str| {
        has_begun.set(true);
        // Nobody waits for a world that was given up.
        let _ = ready.send(address.to_owned());
        Ok(())
    };
    let address = Address::Tcp("127.0.0.1:0".to_owned());
    let serve = ServeOptions { address: &address, anywhere: false, started: &started };
    // Images are not stored: the same world is made again from its rules.
    let record = RecordOptions { path: recording, images: ImagePolicy::None, force: true };
    let mut observer = stops::Stops::new(Arc::clone(pacer));
    let mut control = pacer::Control(Arc::clone(pacer));
    let result = play_controlled(rules, &mut observer, &mut control, Some(record), Some(serve));
    result.map(drop).or_else(|failure| {
        if has_begun.get() {
            return Err(failure);
        }
        // The world or its file cannot be made. Without a file only the world's failure is left.
        let Failed { text, help, .. } = failure.into();
        pacer.not_recorded(&format!("{text}: {help}"));
        play_controlled(rules, &mut observer, &mut control, None, Some(serve)).map(drop)
    })
}
