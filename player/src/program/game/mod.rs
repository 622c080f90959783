//! Games, in whichever world.

pub(crate) mod album;
mod arena;
pub(crate) mod audience;
mod event;
mod fingerprint;
mod firmware;
pub(crate) mod game_loop;
pub(crate) mod latency;
mod meter;
pub(crate) mod record;
pub(crate) mod scene;
mod series;
pub(crate) mod sight;
mod single;
mod story;
pub(crate) mod summary;
mod table;

use std::time::Duration;

use super::cli::Play;
use super::ending::{Ending, Failure};
use super::voice::Voice;
use arena::Arena;
use game_loop::Rules;

/// `player play`: one game, or many.
pub(crate) fn run(args: &Play) -> Result<Ending, Failure> {
    let rules = Rules {
        arena: Arena::asked(args.world)?,
        seed: args.seed,
        size: args.size,
        robots: args.robots,
        limit: Duration::from_secs_f64(args.seconds),
        realtime: args.realtime,
        firmware: firmware::Image::asked(args)?,
    };
    let (voice, pictures) = (Voice::new(args.json), args.pictures.as_deref());
    match args.games {
        None => single::run(&rules, voice, pictures, args.film.as_deref()),
        Some(games) => series::run(&rules, voice, pictures, &series::Plan::new(games, args.threads, args.at_least)),
    }
}
