//! Monitors of the running image: their data and requests; all else must stay unchanged.

mod body;
mod free_running;
mod operators;
mod watchers;

use std::error::Error;
use std::net::SocketAddr;
use std::path::Path;
use std::time::Duration;

use bica_link::{Address, Client, ClientOptions};

use crate::parts::Part;

type Outcome = Result<(), Box<dyn Error>>;

/// Longest wait of a monitor: the emulator is slow on a busy computer.
const PATIENCE: Duration = Duration::from_mins(2);

/// A scenario: the property that it checks, and the check of an image.
type Scenario = (&'static str, fn(&Path) -> Outcome);

/// All scenarios.
const ALL: [Scenario; 5] = [
    ("a watcher of everything attaches in mid-game and changes no command", watchers::everything),
    ("garbage on the monitors' line changes no command, and a monitor attaches after it", watchers::garbage),
    ("a monitor attaches before the game starts, and nobody gets the lease", watchers::before_the_game),
    ("requests act as on the host; holds and rates end 3 s after the operator fell silent", operators::requests),
    ("the robot stands safe when and only when its sensors fall silent", free_running::safe_stand),
];

/// Returns all scenarios as parts of the test.
pub(crate) fn list(image: &Path) -> Vec<Part<'_>> {
    let part = |(name, check): Scenario| -> Part<'_> {
        (format!("monitors: {name}"), Box::new(move || check(image).map(|()| "passed".to_owned())))
    };
    ALL.into_iter().map(part).collect()
}

/// Attaches a monitor.
fn attach(address: SocketAddr) -> Result<Client, Box<dyn Error>> {
    let address: Address = address.to_string().parse()?;
    Ok(Client::connect(&address, ClientOptions { timeout: PATIENCE, ..ClientOptions::default() })?)
}

/// Requires that a property holds.
fn expect(property: bool, what: &str) -> Outcome {
    if property { Ok(()) } else { Err(what.to_owned().into()) }
}
