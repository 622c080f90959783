//! `referee`: a small `GameController` for tests, and for users without the real one.

mod args;
mod command;
mod component;
mod game;
mod players;
mod run;

pub(crate) use args::RefereeCommand;
pub(super) use command::{Command, penalty_name};
pub(super) use game::{Game, PENALTY};
pub(crate) use run::run;
