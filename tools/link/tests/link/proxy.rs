//! Connections that break, or lead to another robot.

use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;

/// Forwards connections to a server until it cuts them.
pub(crate) struct Proxy {
    pub(crate) address: String,
    to: Arc<Mutex<String>>,
    open: Arc<Mutex<Vec<TcpStream>>>,
}

impl Proxy {
    pub(crate) fn start(to: &str) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let (to, open) = (Arc::new(Mutex::new(to.to_owned())), Arc::<Mutex<Vec<TcpStream>>>::default());
        let (server, opened) = (Arc::clone(&to), Arc::clone(&open));
        thread::spawn(move || {
            for client in listener.incoming() {
                let server = server.lock().unwrap().clone();
                let (Ok(client), Ok(server)) = (client, TcpStream::connect(server)) else { return };
                for (from, to) in [(&client, &server), (&server, &client)] {
                    let (mut from, mut to) = (from.try_clone().unwrap(), to.try_clone().unwrap());
                    thread::spawn(move || std::io::copy(&mut from, &mut to));
                }
                opened.lock().unwrap().extend([client, server]);
            }
        });
        Self { address, to, open }
    }

    /// Connects the next ones to another server.
    pub(crate) fn lead_to(&self, to: &str) {
        to.clone_into(&mut self.to.lock().unwrap());
    }

    pub(crate) fn cut(&self) {
        for stream in self.open.lock().unwrap().drain(..) {
            let _ = stream.shutdown(Shutdown::Both);
        }
    }
}
