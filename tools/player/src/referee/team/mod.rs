//! `play --world team` and `play --world mujoco --teams`: a match of two teams in one world.

mod assistants;
mod entrants;
mod figures;
mod fouls;
mod half;
mod halves;
mod links;
mod player;
mod radio;
mod real_time;
mod recording;
mod tally;
mod teams;
mod truth;

pub(super) use recording::{MUJOCO, WORLD};

use bica_app::{Failure, Outcome};

use super::play::refuse_other_network;
use crate::cli::Play;

/// Longest duration of a half, s.
const LONGEST: f64 = i16::MAX as f64;

/// Plays a match in real time, or with `--games` a series of halves in simulated time.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    let Some(teams) = args.referee.teams else {
        return Err(Failure::new("a match needs the numbers of its teams", "give --teams 5,23"));
    };
    refuse(args)?;
    match args.games {
        None => real_time::run(args, teams),
        Some(games) => halves::run(args, teams, games),
    }
}

/// Refuses options that a match does not support.
fn refuse(args: &Play) -> Result<(), Failure> {
    refuse_other_network(args)?;
    if args.pictures.is_some() || args.film.is_some() {
        let what = "a match has no pictures and films";
        return Err(Failure::new(what, "leave out --pictures and --film; --record FOLDER records all robots"));
    }
    let is_node = args.link.serve.is_none() && args.link.address().is_some();
    if is_node || args.link.unpaced {
        let what = "a match is played in real time, and its robots are no ROS nodes";
        return Err(Failure::new(what, "leave out --unpaced and --ros"));
    }
    if args.games.is_none() && args.referee.idle {
        let what = "--idle belongs to a series of halves, and this match follows a GameController";
        return Err(Failure::new(what, "give --games N, too, or leave out --idle"));
    }
    if args.games.is_some() && args.seconds.is_some_and(|seconds| !(1.0..=LONGEST).contains(&seconds)) {
        let what = "a half lasts 1 to 32767 s, as in the packets of a GameController";
        return Err(Failure::new(what, "give other --seconds, or leave it out for 600"));
    }
    if args.games.is_some() && args.referee.truth.is_some() {
        let what = "--truth belongs to a match in real time, and a series of halves has its own clock";
        return Err(Failure::new(what, "leave out --truth or --games"));
    }
    Ok(())
}
