//! The thread that does for each monitor what the loop has no time for.

use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::{io, mem};

use super::cycle_data::CycleData;
use super::exchange::{Exchange, Outgoing, Recipient, Shot};
use super::hub::Hub;

/// Starts the thread. It ends after [`Exchange::close`], once everything is distributed.
pub(super) fn start(hub: &Arc<Hub>) -> io::Result<JoinHandle<()>> {
    let hub = Arc::clone(hub);
    thread::Builder::new().name("link distributor".to_owned()).spawn(move || run(&hub, &hub.exchange))
}

fn run(hub: &Hub, exchange: &Exchange) {
    let mut received = Outgoing::default();
    while exchange.take(&mut received) {
        for (recipient, message) in received.messages.drain(..) {
            match recipient {
                Recipient::One(connection) => connection.push(message),
                Recipient::All => hub.push_to_each(&message),
            }
        }
        received.data.iter_mut().for_each(distribute);
        if let Some(Shot { watchers, picture }) = received.shot.take() {
            // The same image may have been handed over twice.
            let ready = watchers.iter().filter(|watcher| watcher.connection.is_ready_for_image(picture.number));
            ready.for_each(|watcher| watcher.connection.show_image(picture.clone()));
        }
    }
}

/// Encodes the data of a cycle once, and adds it to the queue of each monitor that watches.
fn distribute(data: &mut CycleData) {
    let watchers = mem::take(&mut data.watchers);
    // The limits of the protocol exclude values that do not fit.
    let Ok(encoded) = data.encode().map(Arc::new) else { return };
    for watcher in watchers.iter().filter(|watcher| !watcher.connection.is_closed()) {
        let snapshot = encoded.has_snapshot() && watcher.is_due(encoded.cycle);
        if snapshot || !watcher.watched.is_empty() {
            watcher.connection.show(&encoded, snapshot, &watcher.watched);
        }
    }
}
