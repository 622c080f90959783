//! Lamps behind a link.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use bica::runner::{Robot, Runner, World};
use bica_link::{Address, LinkServer, ServerOptions};
use bica_monitor::protocol::Open;
use bica_recording::Recordable;
use bica_wire::message::Offers;
use serde_json::Value;

use crate::lamp::{CYCLE, EyeTree, LampTree, Room, Sensors};
use crate::page::{Bench, Page};

/// A robot that is served at a TCP port until this value is dropped.
pub(crate) struct Served {
    pub(crate) address: String,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    /// Serves a lamp whose time cannot be paused.
    pub(crate) fn device() -> Self {
        Self::device_at(0)
    }

    /// Serves a lamp whose clock begins at a cycle.
    pub(crate) fn device_at(cycle: u64) -> Self {
        Self::start::<LampTree>("127.0.0.1:0", Offers::default(), cycle)
    }

    /// Serves a lamp in a world that can be paused.
    pub(crate) fn world() -> Self {
        Self::world_at("127.0.0.1:0")
    }

    pub(crate) fn world_at(address: &str) -> Self {
        Self::start::<LampTree>(address, Offers::PAUSE, 0)
    }

    /// Serves a robot with another tree.
    pub(crate) fn other_at(address: &str) -> Self {
        Self::start::<EyeTree>(address, Offers::default(), 0)
    }

    fn start<R>(address: &str, offers: Offers, cycle: u64) -> Self
    where
        R: for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = ()> + Recordable + Default + 'static,
    {
        let mut room = Room::at(cycle);
        let actions = World::<R>::actions(&mut room).map_or(&[][..], |actions| actions.list());
        let (address, options) =
            (Address::Tcp(address.to_owned()), ServerOptions { offers, actions, ..ServerOptions::default() });
        let (server, requests, observer) = LinkServer::start_in_world::<R>(&address, options, &room).unwrap();
        let address = server.address().to_owned();
        let end = Arc::<AtomicBool>::default();
        let ended = Arc::clone(&end);
        let thread = thread::spawn(move || {
            let runner = Runner::new(Box::<R>::default(), room);
            let mut runner = runner.with_requests(requests).with_observer(observer);
            while !ended.load(Ordering::Relaxed) {
                if runner.requests_mut().begins_cycle() {
                    assert!(runner.cycle().is_ok());
                } else {
                    runner.apply_requests();
                }
                runner.observer().show_truth(runner.world());
                thread::sleep(CYCLE);
            }
            drop(server);
        });
        Self { address, end, thread: Some(thread) }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Relaxed);
        let _ = self.thread.take().unwrap().join();
    }
}

/// Opens a robot on a new page, and waits for its description.
pub(crate) fn attached(address: &str) -> (Page, Value) {
    let page = Page::new(&Bench::new());
    page.open(Open::Robot { address: address.to_owned() });
    let description = page.message("described", |message| Some(message["description"].clone()));
    (page, description)
}
