//! A series of halves in simulated time.

use std::sync::atomic::{AtomicU64, Ordering};

use bica::Tree;
use bica_app::{Batch, Console, Failure, Outcome, Progress, in_force, print_in_force};
use bica_player::referee::TeamForward;

use super::figures::Figures;
use super::half::Half;
use super::tally::Tally;
use crate::cli::Play;

/// Plays halves with consecutive seeds and prints their figures.
pub(super) fn run(args: &Play, teams: [u8; 2], games: u32) -> Result<Outcome, Failure> {
    let console = Console::new(args.json);
    let layers = args.tuning.layers(const { &TeamForward::GRAPH }, "team")?;
    print_in_force(console, &in_force(&layers))?;
    let batch = Batch::new(args.seed, games, args.threads);
    let (progress, played) = (Progress::new(batch.runs.into()), AtomicU64::new(0));
    let halves = batch.run(|seed| {
        let half = Half::new(args, teams, seed, &layers)?.play()?;
        progress.show(played.fetch_add(1, Ordering::Relaxed) + 1, "halves");
        Ok(half)
    })?;
    // Halves that Ctrl-C has cut short do not count.
    let halves: Vec<Tally> = halves.into_iter().flatten().collect();
    let playing = if args.referee.idle { &teams[..1] } else { &teams };
    let figures = Figures::new(args.seed, playing, halves);
    figures.print(console)?;
    console.print_json(&figures)?;
    Ok(Outcome::of(true))
}
