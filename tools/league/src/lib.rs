//! Client of `RCSSServerMJ` 0.2.1, the simulation server of RoboCup's 3D soccer league, which is not part of this workspace.
//!
//! [`Server`] starts the server as a process. [`Agent`] is the connection of one player: it reads what the player senses and
//! sends what its motors shall do. [`Monitor`] is the connection of a person beside the field: it places ball and players.
//! Nothing here knows the program of a robot.
//!
//! The server also tells each player the true pose of its torso. [`Perception`] does not contain it: no player can read it.

mod action;
mod agent;
mod body;
mod error;
mod expression;
mod frame;
mod monitor;
mod perception;
mod server;

pub use agent::Agent;
pub use body::Body;
pub use error::Error;
pub use monitor::{FieldSide, Monitor};
pub use perception::{Game, Perception, PlayMode, Seen, Sight};
pub use server::{Address, Server};
