//! A series of games on several threads.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use bica_app::{Batch, Console, Failure, InForce, Outcome, Progress};

use crate::game::Album;
use crate::game::observer::GameObserver;
use crate::game::play::play_recorded;
use crate::game::rules::Rules;
use crate::game::series_summary::{self, SeriesSummary};
use crate::game::summary::{GameResult, GameSummary};

/// Size of a series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeriesOptions {
    /// Number of games.
    pub(crate) games: u32,
    /// Number of threads; `None` uses one for each core.
    pub(crate) threads: Option<u32>,
    /// Number of games with a goal from which the series counts as a success; `None` requires all.
    pub(crate) at_least: Option<u32>,
}

/// Plays a series and prints its summary. With `pictures`, each game has a folder of pictures there.
pub(crate) fn play_series(
    rules: &Rules,
    console: Console,
    pictures: Option<&Path>,
    options: &SeriesOptions,
    layers: Vec<InForce>,
) -> Result<Outcome, Failure> {
    let began = Instant::now();
    let batch = Batch::new(rules.seed, options.games, options.threads);
    let games = play_all(rules, pictures, &batch)?;
    let series = SeriesSummary::new(&batch, games, layers, began.elapsed().as_secs_f64());
    series_summary::print(console, &series)?;
    console.print_json(&series)?;
    let required = options.at_least.unwrap_or(options.games) as usize;
    Ok(Outcome::of(series.goals() >= required))
}

/// Plays all games; returns those that were played to their end, in the order of their seeds.
fn play_all(rules: &Rules, pictures: Option<&Path>, batch: &Batch) -> Result<Vec<GameSummary>, Failure> {
    let progress = Progress::new(batch.runs.into());
    let (played, goals) = (AtomicU64::new(0), AtomicU64::new(0));
    let games = batch.run(|seed| {
        let mut album = pictures.map(|folder| Album::new(&folder.join(format!("seed-{seed}")))).transpose()?;
        let mut observers: Vec<&mut dyn GameObserver> = album.iter_mut().map(|album| album as _).collect();
        let (game, _) = play_recorded(&Rules { seed, ..*rules }, &mut observers[..], None, None)?;
        let add = |count: &AtomicU64, more| more + count.fetch_add(more, Ordering::Relaxed);
        let goals = add(&goals, u64::from(game.result == GameResult::Goal));
        progress.show(add(&played, 1), &format!("{goals} goals"));
        Ok(game)
    });
    Ok(games?.into_iter().filter(|game| game.result != GameResult::Interrupted).collect())
}
