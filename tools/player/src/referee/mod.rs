//! Games under the commands of a `GameController`: `play --referee`, and the command `referee`, a small `GameController`.

mod controller;
mod network;
mod play;
mod team;
mod team_network;
mod world;

pub(crate) use controller::{RefereeCommand, run as command};
pub(crate) use play::{replay, run};
pub(crate) use team::run as run_match;
