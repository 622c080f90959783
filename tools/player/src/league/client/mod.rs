//! Client of `RCSSServerMJ` 0.2.1, the simulation server of RoboCup's 3D soccer league, which is not part of this workspace.
//!
//! [`Server`] starts the server as a process. [`Agent`] is the connection of one player: it receives the player's
//! perception and sends the targets of its motors. [`Monitor`] is a connection that places ball and players. This
//! module does not depend on the program of a robot.
//!
//! The server also sends each player the true pose of its torso. [`Perception`] does not contain it, so no player can read it.

mod action;
mod agent;
pub(crate) mod body;
mod error;
mod expression;
mod frame;
mod monitor;
mod perception;
mod server;
#[cfg(test)]
pub(crate) mod tests;

pub(crate) use agent::Agent;
pub(crate) use body::Body;
pub(crate) use error::Error;
pub(crate) use monitor::Monitor;
pub(crate) use perception::{Perception, PlayMode, Seen, Sight};
pub(crate) use server::{Address, Server};
