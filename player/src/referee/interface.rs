//! What a player of a team senses and commands.

use bica::prelude::*;
use bica_motion::robot::{Command, Sensors};

use super::packet::{Control, Status};
use crate::team::{Heard, TeamMessage};

/// Which player of which team a robot is.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// Number of the team.
    pub team: u8,
    /// Number of the player, 1 to 20.
    pub player: u8,
}

/// A control packet that has arrived.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Received {
    /// Its content; the own team is one of the two.
    pub control: Control,
    /// Address of its sender: IPv4.
    pub source: [u8; 4],
    /// Time of its arrival on the clock of the world, µs.
    pub at_us: u64,
}

/// Sensor values of a cycle, with what the network brought.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct TeamSensors<'a> {
    /// Sensor values of the body.
    pub body: Sensors<'a>,
    /// Which player the robot is.
    pub me: Identity,
    /// A control packet that has arrived since the last cycle.
    pub packet: Option<Received>,
    /// Number of all other datagrams that came to the same port so far.
    pub ignored: u32,
    /// A message of another player of the team that has arrived since the last cycle.
    pub heard: Option<Heard>,
    /// Number of all other datagrams that came to the port of the team so far.
    pub refused: u32,
}

/// A status message and its receiver.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Address of the `GameController`: IPv4.
    pub to: [u8; 4],
    /// The message.
    pub status: Status,
}

/// Command of a cycle, with what the network shall take.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TeamCommand {
    /// Command of the body.
    pub body: Command,
    /// A message for the `GameController`; `None` in most cycles.
    pub answer: Option<Answer>,
    /// A message for the other players of the team; `None` in most cycles.
    pub message: Option<TeamMessage>,
}
