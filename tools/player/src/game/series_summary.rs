//! Summary of a series of games.

use bica_app::{Batch, Console, Failure, InForce, Style};
use bica_evaluation::statistics::percentile;
use bica_recording::processor;
use serde::Serialize;

use crate::game::latency::{Latencies, LatencySummary};
use crate::game::summary::{GameResult, GameSummary};
use crate::game::summary_text::latency;

/// Summary of a series. It is reproducible except for fields whose names contain `wall`.
#[derive(Debug, Serialize)]
pub(crate) struct SeriesSummary {
    schema: &'static str,
    first_seed: u64,
    requested: u64,
    summary: Totals,
    games: Vec<GameSummary>,
    layers: Vec<InForce>,
    wall_processor: String,
    wall: Wall,
}

#[derive(Debug, Serialize)]
struct Totals {
    played: usize,
    goals: usize,
    own_goals: usize,
    falls: usize,
    games_with_falls: usize,
    seeds_with_falls: Vec<u64>,
    /// Times to the goal in the games with a goal, s.
    time_to_goal_s: Option<Times>,
    seeds_without_goal: Vec<u64>,
}

#[derive(Debug, Serialize)]
struct Times {
    min: f64,
    p50: f64,
    p90: f64,
    max: f64,
}

#[derive(Debug, Serialize)]
struct Wall {
    threads: usize,
    real_s: f64,
    latency_ms: LatencySummary,
}

impl SeriesSummary {
    /// Creates the summary of a batch of games that took `real_s` seconds of real time.
    pub(crate) fn new(batch: &Batch, games: Vec<GameSummary>, layers: Vec<InForce>, real_s: f64) -> Self {
        let mut all = Latencies::default();
        for game in &games {
            all.extend(&game.latencies);
        }
        Self {
            schema: "bica-player/games/1",
            first_seed: batch.first_seed,
            requested: batch.runs.into(),
            summary: Totals::new(&games),
            games,
            layers,
            wall_processor: processor(),
            wall: Wall { threads: batch.threads, real_s, latency_ms: all.summarize() },
        }
    }

    /// Number of games with a goal.
    pub(crate) const fn goals(&self) -> usize {
        self.summary.goals
    }
}

impl Totals {
    fn new(games: &[GameSummary]) -> Self {
        let won = |game: &&GameSummary| game.result == GameResult::Goal;
        let mut times: Vec<f64> = games.iter().filter_map(|game| game.goal_s).collect();
        times.sort_by(f64::total_cmp);
        let at = |part| percentile(&times, part);
        let times = at(0.0).zip(at(0.5)).zip(at(0.9).zip(at(1.0)));
        Self {
            played: games.len(),
            goals: games.iter().filter(won).count(),
            own_goals: games.iter().map(|game| game.own_goals).sum(),
            falls: games.iter().map(|game| game.falls).sum(),
            games_with_falls: games.iter().filter(|game| game.falls > 0).count(),
            seeds_with_falls: games.iter().filter(|game| game.falls > 0).map(|game| game.seed).collect(),
            time_to_goal_s: times.map(|((min, p50), (p90, max))| Times { min, p50, p90, max }),
            seeds_without_goal: games.iter().filter(|game| !won(game)).map(|game| game.seed).collect(),
        }
    }
}

/// Prints the summary.
pub(crate) fn print(console: Console, series: &SeriesSummary) -> Result<(), Failure> {
    let SeriesSummary { summary: totals, wall, .. } = series;
    let percent = 100.0 * totals.goals as f64 / totals.played.max(1) as f64;
    let style = if totals.goals == totals.played { Style::Good } else { Style::Plain };
    let seeds = format!("seeds {} to {}", series.first_seed, series.first_seed.wrapping_add(series.requested - 1));
    let missing = match series.requested - totals.played as u64 {
        0 => String::new(),
        missing => format!(", {missing} not played to the end"),
    };
    console.print_row(
        "games",
        &format!("{}{missing}   {seeds}, {} threads, {:.1} s", totals.played, wall.threads, wall.real_s),
    )?;
    console.print_row(
        "goals",
        &console.styled(style, &format!("{} of {} ({percent:.0} %)", totals.goals, totals.played)),
    )?;
    let times = totals.time_to_goal_s.as_ref().map_or_else(
        || "-".to_owned(),
        |Times { min, p50, p90, max }| format!("p50 {p50:.1} s  p90 {p90:.1} s  (from {min:.1} to {max:.1} s)"),
    );
    console.print_row("time to goal", &times)?;
    console.print_row("own goals", &totals.own_goals.to_string())?;
    let which = match &totals.seeds_with_falls[..] {
        [] => String::new(),
        seeds => format!("; seeds {}", list(seeds)),
    };
    console.print_row("falls", &format!("{} in {} games{which}", totals.falls, totals.games_with_falls))?;
    console.print_row("latency", &latency(&wall.latency_ms))?;
    if totals.seeds_without_goal.is_empty() {
        return Ok(());
    }
    console.print_row("no goal", &format!("seeds {}", list(&totals.seeds_without_goal)))
}

fn list(seeds: &[u64]) -> String {
    seeds.iter().map(u64::to_string).collect::<Vec<_>>().join(" ")
}
