//! The node of a robot in this process, in a thread of its own. The end of the thread never stops the robot.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use bica_link::{Address, Client, ClientOptions, Error};
use bica_wire::message::WorldChange;
use bica_wire::model::{Description, Invalid};

use super::checked::checked;
use super::network::Network;
use super::{Bridge, Options};

/// A node of a robot that runs in this process. It leaves the network when it is dropped.
#[derive(Debug)]
pub struct Ros {
    stopped: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
    name: String,
}

impl Ros {
    /// Starts a node for the robot that is served at an address. A paused world in this process continues once the node exists.
    /// `description` is that of the robot's tree.
    ///
    /// # Errors
    /// If the node cannot be created.
    pub fn start(address: &Address, description: &Description, options: &Options) -> Result<Self, Invalid> {
        let names = checked(description, options)?;
        let (network, name) = (Network::join(options, &names)?, names.full());
        let stopped = Arc::new(AtomicBool::new(false));
        let (stop, address, options) = (Arc::clone(&stopped), address.clone(), options.clone());
        let work = move || {
            let mut resume_at_end = ResumeAtEnd { address: &address, is_needed: true };
            let work = || {
                let link = Client::connect(&address, ClientOptions::default())?;
                let mut bridge = Bridge::new(link, network, &names, options.operator)?;
                bridge.begin()?;
                if matches!(address, Address::Memory(_)) && bridge.robot.simulated {
                    resume(&mut bridge.robot.link, false)?;
                }
                bridge.run(&|| stop.load(Ordering::Relaxed))
            };
            match work() {
                Ok(()) => resume_at_end.is_needed = false,
                Err(Invalid { what, help, .. }) => {
                    eprintln!("warning: the ROS node has ended, the run goes on: {what}; {help}");
                }
            }
        };
        let thread = thread::Builder::new().name("ros".to_owned()).spawn(work);
        let thread =
            thread.map_err(|error| Invalid::new(format!("cannot start a thread: {error}"), "is there memory left?"));
        Ok(Self { stopped, thread: Some(thread?), name })
    }

    /// Returns the full name of the node.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl Drop for Ros {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // A panic of the thread has printed its message.
            let _ = thread.join();
        }
    }
}

/// Continues a world that waits for its monitor.
fn resume(link: &mut Client, take: bool) -> Result<(), Error> {
    link.acquire(take)?;
    link.change_world(WorldChange::Resume)?;
    link.release()
}

/// Continues a paused world of this process when its node ends before the run: it has no other monitor.
struct ResumeAtEnd<'a> {
    address: &'a Address,
    is_needed: bool,
}

impl Drop for ResumeAtEnd<'_> {
    fn drop(&mut self) {
        if self.is_needed && matches!(self.address, Address::Memory(_)) {
            // Without a link the run has ended, or cannot be paused.
            let _ =
                Client::connect(self.address, ClientOptions::default()).and_then(|mut link| resume(&mut link, true));
        }
    }
}
