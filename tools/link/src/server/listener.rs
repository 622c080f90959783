//! Acceptance of connections.

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::hub::Hub;
use super::session;
use crate::address::{Address, resolve};
use crate::error::Error;
use crate::stream::Stream;

/// Time between two checks for a new connection.
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
            let next = move || {
                let accepted = listener.accept().and_then(|(stream, _)| Stream::tcp(stream));
                accepted.inspect_err(|_| thread::sleep(ACCEPT)).ok()
            };
            Ok((bound, thread.spawn(move || accept(&hub, next)).map_err(failed)?))
        }
        Address::Memory(memory) => {
            let place = memory.clone();
            let serve = move || {
                accept(&hub, || place.accept(ACCEPT));
                place.close();
            };
            let listener = thread.spawn(serve).map_err(failed)?;
            memory.serve();
            Ok((address.to_string(), listener))
        }
        Address::Serial { path, baud } => {
            // Opened here, so that a wrong path is an error.
            let first = Stream::open(path, *baud).map_err(failed)?;
            let (path, baud) = (path.clone(), *baud);
            let serve = move || {
                let mut stream = Ok(first);
                while !hub.stopped.load(Ordering::Relaxed) {
                    if let Ok(stream) = stream {
                        // The error is ignored: the line is opened again in any case.
                        let _ = session::serve(&hub, stream);
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

/// Serves each connection in a thread of its own. `next` waits for a short time.
fn accept(hub: &Arc<Hub>, next: impl Fn() -> Option<Stream>) {
    while !hub.stopped.load(Ordering::Relaxed) {
        let Some(stream) = next() else { continue };
        let hub = Arc::clone(hub);
        let serve = move || {
            // The monitor is gone: there is nobody to report an error to.
            let _ = session::serve(&hub, stream);
        };
        let _ = thread::Builder::new().name("link reader".to_owned()).spawn(serve);
    }
}
