//! Packets of the `GameController` of the merged league: control packets of versions 19 and 20, and the status message of a player.
//!
//! Source: headers of the `GameController`'s release 6.0.1 (`RoboCup-HumanoidSoccerLeague/GameController`, 30a47f8). The penalties of
//! version 20 are those of `HULKs/hulk` and `BoosterRobotics/robocup_demo`. All numbers are little-endian.

mod bytes;
mod control;
mod mismatch;
mod penalty;
mod status;
mod values;

pub(crate) use bytes::{Reader, Writer};
pub use control::{CONTROL_BYTES, Control, PLAYERS, PlayerInfo, Team, UncodedPenalty};
pub use mismatch::{Ignored, Mismatch};
pub use penalty::Penalty;
pub use status::{BallReport, STATUS_BYTES, Status, StatusMismatch};
pub use values::{GamePhase, PlayState, SetPlay, Version};
