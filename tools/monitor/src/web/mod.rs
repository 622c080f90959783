//! Web server: the page's files and a WebSocket for each page.
//!
//! The server is designed for a computer that other programs and web pages share. It first compares the `Host` of a request with a
//! list, so that a foreign name that resolves to this computer (DNS rebinding) is refused. Plain HTTP serves the page's files,
//! which contain no secret, and changes nothing. A WebSocket needs an `Origin` equal to the server's own. Its first message must
//! prove that the page may enter: by the key of a URL that works for one page, by the secret that the page received for such a key and
//! keeps in the storage of its origin, or by the token. A cookie is not sufficient, because browsers send it to every port of a
//! host. Input is limited in size, number and rate. Output to a slow page is dropped, or the page is disconnected ([`Queue`]).

mod access;
mod assets;
mod guard;
mod headers;
mod hosts;
mod numbers;
mod pending_connections;
mod queue;
mod rate;
mod serve;
mod socket;

use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::thread::JoinHandle;

use tokio::sync::{Semaphore, watch};

use crate::sessions::Manager;
pub(crate) use access::secret;
pub use access::{Access, Enter};
pub use hosts::Hosts;
pub use queue::Queue;

/// Largest number of pages.
const MAX_PAGES: usize = 32;

/// Options of the server.
#[derive(Clone, Debug, Default)]
pub struct WebOptions {
    /// Names under which other computers reach the server, besides its addresses.
    pub names: Vec<String>,
    /// Secret with which a page can enter at any time; required where other computers reach the server.
    pub token: Option<String>,
}

/// State that all requests share.
pub(crate) struct Shared {
    pub(crate) hosts: Hosts,
    pub(crate) access: Access,
    pub(crate) manager: Arc<Manager>,
    /// Permits for pages that have entered.
    pub(crate) pages: Arc<Semaphore>,
}

/// A running server.
pub struct Web {
    address: SocketAddr,
    shared: Arc<Shared>,
    stop: watch::Sender<bool>,
    thread: Option<JoinHandle<()>>,
}

impl Web {
    /// Starts a server on a listener, in a new thread.
    ///
    /// # Errors
    /// If the thread or its runtime cannot be started, if the system has no random numbers, or if an address other than loopback
    /// has no token or the manager edits sources.
    pub fn start(listener: TcpListener, options: WebOptions, manager: Arc<Manager>) -> io::Result<Self> {
        let address = listener.local_addr()?;
        if !address.ip().is_loopback() && options.token.is_none() {
            return Err(io::Error::other("an address that other computers reach needs a token"));
        }
        if !address.ip().is_loopback() && manager.edits_sources() {
            return Err(io::Error::other("sources are edited and built from this computer only"));
        }
        listener.set_nonblocking(true)?;
        let shared = Arc::new(Shared {
            hosts: Hosts::new(address, options.names),
            access: Access::new(options.token)?,
            manager,
            pages: Arc::new(Semaphore::new(MAX_PAGES)),
        });
        let (stop, stopped) = watch::channel(false);
        let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build()?;
        let served = Arc::clone(&shared);
        let thread = std::thread::Builder::new()
            .name("web".to_owned())
            .spawn(move || runtime.block_on(serve::serve(listener, served, stopped)))?;
        Ok(Self { address, shared, stop, thread: Some(thread) })
    }

    /// The address of the server.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Returns a new URL that admits one page, once. Its key is in the fragment, which browsers do not send in requests.
    ///
    /// # Errors
    /// If the operating system has no random numbers.
    pub fn url(&self) -> io::Result<String> {
        Ok(format!("http://{}/#key={}", self.shared.hosts.own(), self.shared.access.new_key()?))
    }
}

impl Drop for Web {
    fn drop(&mut self) {
        let _ = self.stop.send(true);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
