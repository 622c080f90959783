//! The robot's end of the link.

mod conditions;
mod connection;
mod control;
mod counters;
mod cycle_data;
mod extras;
mod hub;
mod images;
mod key;
mod listener;
mod observer;
mod options;
mod outbox;
mod pace;
mod requests;
mod scene;
mod sending;
mod session;
mod show;
mod snapshot;
mod stops;
mod view;
mod watcher;
mod watchers;

use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::Duration;

use bica::runner::World;
use bica::visual::Scene;
use bica_wire::Recordable;
use bica_wire::message::{LogSource, Offers, WorldChange};

use crate::address::Address;
use crate::error::Error;
use control::Control;
use hub::Hub;
use scene::{EncodedScene, WorldScenes};

pub use counters::LinkStats;
pub use observer::LinkObserver;
pub use options::{MAX_MONITORS, ServerOptions};
pub use requests::LinkRequests;
pub use show::LinkShow;

/// Longest wait for the last messages when a server ends.
const LAST_MESSAGES: Duration = Duration::from_millis(500);

/// Server that accepts monitors of a running robot. Dropping it closes all connections.
#[derive(Debug)]
pub struct LinkServer {
    hub: Arc<Hub>,
    address: String,
    listener: Option<JoinHandle<()>>,
}

impl LinkServer {
    /// Starts a server for a robot. In this process a world that can be paused begins paused: its monitor continues it after it
    /// has begun to watch, and so misses no cycle. Returns the server and its two parts for the loop, for
    /// [`Runner::with_requests`](bica::runner::Runner::with_requests) and
    /// [`Runner::with_observer`](bica::runner::Runner::with_observer).
    ///
    /// # Errors
    /// [`Error::NotLoopback`], or [`Error::Connect`] if it cannot listen there.
    pub fn start<R: Recordable>(
        address: &Address,
        options: ServerOptions,
    ) -> Result<(Self, LinkRequests, LinkObserver<R>), Error> {
        Self::start_with(address, options, WorldScenes::default())
    }

    /// Starts a server as [`start`](Self::start), for a robot in a simulated world: monitors get its scenery, and its true state if it
    /// shows one. The loop calls [`LinkObserver::show_truth`].
    ///
    /// # Errors
    /// As [`start`](Self::start).
    pub fn start_in_world<R: Recordable>(
        address: &Address,
        options: ServerOptions,
        world: &(impl World<R> + ?Sized),
    ) -> Result<(Self, LinkRequests, LinkObserver<R>), Error> {
        Self::start_in_scene(address, options, |scene| world.scenery(scene), |scene| world.truth(scene))
    }

    /// Starts a server as [`start_in_world`](Self::start_in_world) does, for a loop that owns no [`World`]: the functions show the scenery
    /// and the true state. The loop calls [`LinkObserver::show_scene`].
    ///
    /// # Errors
    /// As [`start`](Self::start).
    pub fn start_in_scene<R: Recordable>(
        address: &Address,
        options: ServerOptions,
        scenery: impl FnOnce(&mut dyn Scene),
        truth: impl FnOnce(&mut dyn Scene),
    ) -> Result<(Self, LinkRequests, LinkObserver<R>), Error> {
        let has_truth = !EncodedScene::of(truth).values.is_empty();
        let offers = options.offers.with(if has_truth { Offers::TRUTH } else { Offers::default() });
        let shown = WorldScenes::of_scenery(EncodedScene::of(scenery));
        Self::start_with(address, ServerOptions { offers, ..options }, shown)
    }

    /// Starts a server that shows a recorded robot. `robot` has the values of the parameters at the start of its recording.
    /// Monitors may only watch.
    ///
    /// # Errors
    /// As [`start`](Self::start).
    pub fn start_show<R: Recordable>(
        address: &Address,
        options: ServerOptions,
        robot: Box<R>,
    ) -> Result<(Self, LinkShow<R>), Error> {
        let options = ServerOptions { watch_only: true, ..options };
        let (server, requests, control) = Self::begin::<R>(address, options, WorldScenes::default(), true)?;
        Ok((server, LinkShow::new(requests, control, robot)))
    }

    fn start_with<R: Recordable>(
        address: &Address,
        options: ServerOptions,
        shown: WorldScenes,
    ) -> Result<(Self, LinkRequests, LinkObserver<R>), Error> {
        let (server, requests, control) = Self::begin::<R>(address, options, shown, false)?;
        Ok((server, requests, LinkObserver::new(control)))
    }

    fn begin<R: Recordable>(
        address: &Address,
        options: ServerOptions,
        shown: WorldScenes,
        is_recorded: bool,
    ) -> Result<(Self, LinkRequests, Arc<Mutex<Control>>), Error> {
        let messages = [R::SENSORS, R::COMMAND];
        let (hub, inboxes) = Hub::new(const { &R::GRAPH }, R::HASH, messages, &options, is_recorded);
        let hub = Arc::new(hub);
        let (bound, listener) = listener::start(&hub, address, options.anywhere)?;
        let mut control = Control::new(Arc::clone(&hub), options, shown);
        if matches!(address, Address::Memory(_)) && control.can_pause() {
            control.pace.change(WorldChange::Pause);
        }
        let control = Arc::new(Mutex::new(control));
        let requests = LinkRequests::new(inboxes, Arc::clone(&control));
        Ok((Self { hub, address: bound, listener: Some(listener) }, requests, control))
    }

    /// Returns the address, with the port that the operating system chose for port 0.
    #[must_use]
    pub fn address(&self) -> &str {
        &self.address
    }

    /// Sends a line of the log to every monitor, with the time of the last cycle. `level` is 1 debug, 2 information,
    /// 3 warning, 4 error.
    pub fn log(&self, level: u8, source: LogSource, text: &str) {
        self.hub.log(level, source, text);
    }

    /// Sends an event of the world to every monitor, with the time of the last cycle: its kind, as `goal`, and details.
    pub fn event(&self, kind: &str, detail: &str) {
        self.hub.happened(kind, detail);
    }

    /// Sets the result of the run, for people, such as `done after 12.00 s`. Every monitor receives it, even one that attaches
    /// later.
    pub fn set_result(&self, text: &str) {
        self.hub.set_result(text);
    }

    /// Returns the counts since the start.
    #[must_use]
    pub fn stats(&self) -> LinkStats {
        self.hub.counters.stats()
    }
}

impl Drop for LinkServer {
    fn drop(&mut self) {
        self.hub.end("the run has ended", LAST_MESSAGES);
        self.hub.stopped.store(true, Ordering::Relaxed);
        if let Some(listener) = self.listener.take() {
            // A panic of the thread has printed its message.
            let _ = listener.join();
        }
    }
}
