//! Permission to command the robot: the lease of the link, for one ROS process at a time.

use std::time::{Duration, Instant};

use bica_link::Client;
use ros2_client::Gid;

/// Silence after which the lease ends, as that of an operator of the link.
const SILENCE: Duration = Duration::from_secs(3);
/// Silence after which a node may acquire a lost lease again. The lease is lost by a stop, or to another operator.
const PAUSE: Duration = Duration::from_secs(1);
/// Number of leading bytes that the identifiers of everything in a process have in common.
const PROCESS: usize = 12;

/// A process that takes part in a domain: the beginning of the identifiers of its publishers and clients.
type Process = [u8; PROCESS];

/// The operator among the ROS nodes.
#[derive(Debug)]
pub(super) struct Operator {
    /// Whether every node may command whenever the lease is free.
    everyone: bool,
    /// Process that has the lease.
    holder: Option<Process>,
    /// Time of its last request.
    heard: Instant,
    /// Name of the service that acquires the lease.
    service: String,
}

fn process(id: Gid) -> Process {
    let mut process = Process::default();
    process.copy_from_slice(&id.as_bytes()[..PROCESS]);
    process
}

impl Operator {
    pub(super) fn new(everyone: bool, service: String) -> Self {
        Self { everyone, holder: None, heard: Instant::now(), service }
    }

    /// Acquires the lease for the process of a client; with `take` also from another operator.
    pub(super) fn acquire(&mut self, link: &mut Client, id: Gid, take: bool) -> Result<(), String> {
        let process = process(id);
        let is_other = self.holder.is_some_and(|holder| holder != process) && !self.everyone;
        if link.lease().yours && is_other && !take {
            return Err("another ROS process has the lease".to_owned());
        }
        if !link.lease().yours || take {
            link.acquire(take).map_err(|error| error.to_string())?;
        }
        (self.holder, self.heard) = (Some(process), Instant::now());
        Ok(())
    }

    /// Gives the lease back; its holds and rates end.
    pub(super) fn release(&mut self, link: &mut Client, id: Gid) -> Result<(), String> {
        self.check(link, id)?;
        self.holder = None;
        link.release().map_err(|error| error.to_string())
    }

    /// Checks whether the process of a client or publisher may command. If so, its silence ends.
    pub(super) fn check(&mut self, link: &mut Client, id: Gid) -> Result<(), String> {
        if !link.lease().yours
            && self.holder.is_some()
            && std::mem::replace(&mut self.heard, Instant::now()).elapsed() < PAUSE
        {
            return Err(format!(
                "control has ended; command nothing for {} s, or call {}",
                PAUSE.as_secs(),
                self.service
            ));
        }
        if !link.lease().yours {
            self.holder = None;
        }
        if self.everyone {
            return self.acquire(link, id, false);
        }
        if self.holder != Some(process(id)) {
            let other = if link.lease().owned { "another operator has the lease" } else { "nobody has the lease" };
            return Err(format!("{other}; call {} first, or start the robot with --ros-operator", self.service));
        }
        self.heard = Instant::now();
        Ok(())
    }

    /// Ends the lease if its owner is silent.
    pub(super) fn end_silence(&mut self, link: &mut Client) -> Result<(), bica_link::Error> {
        if link.lease().yours && self.heard.elapsed() > SILENCE {
            self.holder = None;
            link.release()?;
        }
        Ok(())
    }
}
