//! What a run is given, and how it stands.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bica_camera::Origin;
use bica_motion::robot::{Buttons, Command};

use crate::CYCLE_MICROS;
use crate::ending::Reason;
use crate::identity::Identity;

/// Longest time that a robot program takes for a cycle, a generous one: a computer may be busy, and a simulated robot waits.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// Where the robot is, and how it is ended.
pub struct Options {
    /// LoLA's socket.
    pub socket: PathBuf,
    /// Where camera images come from; `None`: the robot program gets no images.
    pub images: Option<Origin>,
    /// Makes the command of a process that runs [`guard()`](crate::guard()), from the path of the socket: it owns the socket, and lets the
    /// robot sit down if this process is killed. `None`: a killed process leaves the robot as it is.
    pub guard: Option<fn(&Path) -> process::Command>,
    /// Longest duration of the run, s of the robot's time.
    pub limit: Option<f64>,
    /// Whether the program was asked to end.
    pub stop: Box<dyn Fn() -> bool + Send>,
    /// Time without a command of the robot program, by the clock of this computer, after which the program counts as hung: the robot sits
    /// down. [`PATIENCE`], except in tests.
    pub patience: Duration,
    /// Called after a run that ended because its program hangs: nobody else can end this process.
    pub abandon: fn(),
    /// Says something to people.
    pub say: fn(&str),
    /// Asks the robot program to end its motion before the robot sits down, by buttons: gets the number of the cycle since the request, and
    /// the last command.
    pub halt: fn(u32, &mut Buttons, &Command),
    /// How the run went, for the one who has started it.
    pub standing: Arc<Mutex<Standing>>,
}

/// How a run stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Standing {
    /// The robot of the last map.
    pub identity: Option<Identity>,
    /// Number of valid maps.
    pub maps: u64,
    /// Number of times that bytes were dropped which are no valid map.
    pub rejected: u64,
    /// Number of times that the socket was opened.
    pub opened: u64,
    /// Number of maps that were answered with the newest targets because the robot program was late.
    pub late: u64,
    /// Why the run ended.
    pub reason: Option<Reason>,
    /// Whether the robot sat or lay when its joints became limp.
    pub is_low: bool,
}

impl Standing {
    /// Time of the robot, s: that of its maps.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        (self.maps * CYCLE_MICROS) as f64 * 1e-6
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { identity, maps, rejected, opened, late, reason, .. } = self;
        write!(f, "{maps} maps, {late} of them late, {rejected} not used; the socket was opened {opened} times")?;
        reason.map_or(Ok(()), |reason| write!(f, "; {reason}"))?;
        identity.map_or(Ok(()), |identity| write!(f, "; {identity}"))
    }
}
