//! Games under the commands of a `GameController`: `play --referee`, and the command `referee`, a small `GameController`.

mod controller;
mod network;
mod play;
mod team_match;
mod team_network;
mod truth;
mod world;

pub(crate) use controller::{RefereeCommand, run as command};
pub(crate) use play::{replay, run};
pub(crate) use team_match::run as run_match;
