//! Acceptance of connections.

use std::io;
use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bica_wire::ToMonitor;

use super::MAX_MONITORS;
use super::connection;
use super::hub::Hub;
use crate::address::{Address, resolve};
use crate::error::Error;
use crate::frame::Packets;
use crate::stream::Stream;

/// Time between two looks for a new connection.
const ACCEPT: Duration = Duration::from_millis(10);
/// Time after which a serial line that failed is opened again.
const REOPEN: Duration = Duration::from_secs(1);

/// Starts to listen; returns the address and the thread.
pub(super) fn start(hub: &Arc<Hub>, address: &Address, anywhere: bool) -> Result<(String, JoinHandle<()>), Error> {
    let failed = |error| Error::connect(address, error);
    let hub = Arc::clone(hub);
    let thread = thread::Builder::new().name("link".to_owned());
    match address {
        Address::Tcp(host) => {
            let sockets = resolve(host)?;
            if let Some(socket) = sockets.iter().find(|socket| !anywhere && !socket.ip().is_loopback()) {
                return Err(Error::NotLoopback(socket.to_string()));
            }
            let listener = TcpListener::bind(&*sockets).map_err(failed)?;
            listener.set_nonblocking(true).map_err(failed)?;
            let bound = listener.local_addr().map_err(failed)?.to_string();
            Ok((bound, thread.spawn(move || accept(&hub, &listener)).map_err(failed)?))
        }
        Address::Serial { path, baud } => {
            // Opened here, so that a wrong path is an error.
            let first = Stream::open(path, *baud).map_err(failed)?;
            let (path, baud) = (path.clone(), *baud);
            let serve = move || {
                let mut stream = Ok(first);
                while !hub.stopped.load(Ordering::Relaxed) {
                    if let Ok(stream) = stream {
                        let _serving = Serving::new(&hub);
                        // The reason is of no use: the line is opened again in any case.
                        let _ = connection::serve(&hub, stream);
                    } else {
                        thread::sleep(REOPEN);
                    }
                    stream = Stream::open(&path, baud);
                }
            };
            Ok((address.to_string(), thread.spawn(serve).map_err(failed)?))
        }
    }
}

fn accept(hub: &Arc<Hub>, listener: &TcpListener) {
    while !hub.stopped.load(Ordering::Relaxed) {
        let Ok((stream, _)) = listener.accept() else {
            thread::sleep(ACCEPT);
            continue;
        };
        let Ok(stream) = Stream::tcp(stream) else { continue };
        if hub.open.load(Ordering::Relaxed) >= MAX_MONITORS {
            hub.rejected.fetch_add(1, Ordering::Relaxed);
            reject(stream);
            continue;
        }
        let serving = Serving::new(hub);
        let serve = move || {
            let serving = serving;
            // The monitor is gone: there is nobody to report an error to.
            let _ = connection::serve(&serving.0, stream);
        };
        let _ = thread::Builder::new().name("link reader".to_owned()).spawn(serve);
    }
}

/// Tells a monitor why its connection is closed.
fn reject(mut stream: Stream) {
    let mut packets = Packets::new();
    let told = packets.push(&ToMonitor::Closing { reason: "too many monitors are attached" }).is_ok();
    // The packet fits into the empty buffer of a new connection, so this does not wait.
    let _: io::Result<()> = if told { packets.write(&mut stream) } else { Ok(()) };
    stream.shut_down();
}

/// A connection that counts as open.
struct Serving(Arc<Hub>);

impl Serving {
    fn new(hub: &Arc<Hub>) -> Self {
        hub.open.fetch_add(1, Ordering::Relaxed);
        Self(Arc::clone(hub))
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}
