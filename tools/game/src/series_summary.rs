//! What many games were like together.

use serde::Serialize;

use super::latency::{Latencies, Latency};
use super::summary::{GameResult, Record};
use super::summary_text::latency;
use bica_console::Failure;
use bica_console::statistics::percentile;
use bica_console::{Console, Style};

/// Many games. All but what is named `wall` is the same whenever the same games are played.
#[derive(Debug, Serialize)]
pub struct Series {
    schema: &'static str,
    first_seed: u64,
    asked: u64,
    summary: Sum,
    games: Vec<Record>,
    wall: Wall,
}

#[derive(Debug, Serialize)]
struct Sum {
    played: usize,
    goals: usize,
    own_goals: usize,
    falls: usize,
    games_with_falls: usize,
    seeds_with_falls: Vec<u64>,
    /// Over the games with a goal, s.
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
    latency_ms: Latency,
}

impl Series {
    /// Sums games up.
    pub fn new(first_seed: u64, asked: u64, games: Vec<Record>, threads: usize, real_s: f64) -> Self {
        let mut all = Latencies::default();
        for game in &games {
            all.extend(&game.latencies);
        }
        let wall = Wall { threads, real_s, latency_ms: all.sum_up() };
        Self { schema: "bica-player/games/1", first_seed, asked, summary: Sum::new(&games), games, wall }
    }

    /// How many games ended in a goal.
    pub const fn goals(&self) -> usize {
        self.summary.goals
    }
}

impl Sum {
    fn new(games: &[Record]) -> Self {
        let won = |game: &&Record| game.result == GameResult::Goal;
        let mut times: Vec<f64> = games.iter().filter_map(|game| game.goal_s).collect();
        times.sort_by(f64::total_cmp);
        let at = |part| percentile(&times, part);
        Self {
            played: games.len(),
            goals: games.iter().filter(won).count(),
            own_goals: games.iter().map(|game| game.own_goals).sum(),
            falls: games.iter().map(|game| game.falls).sum(),
            games_with_falls: games.iter().filter(|game| game.falls > 0).count(),
            seeds_with_falls: games.iter().filter(|game| game.falls > 0).map(|game| game.seed).collect(),
            time_to_goal_s: at(0.0).zip(at(0.5)).zip(at(0.9).zip(at(1.0))).map(|((min, p50), (p90, max))| Times {
                min,
                p50,
                p90,
                max,
            }),
            seeds_without_goal: games.iter().filter(|game| !won(game)).map(|game| game.seed).collect(),
        }
    }
}

/// Tells people.
pub fn tell(console: Console, series: &Series) -> Result<(), Failure> {
    let Series { summary: sum, wall, .. } = series;
    let percent = 100.0 * sum.goals as f64 / sum.played.max(1) as f64;
    let style = if sum.goals == sum.played { Style::Good } else { Style::Plain };
    let seeds = format!("seeds {} to {}", series.first_seed, series.first_seed.wrapping_add(series.asked - 1));
    let missing = match series.asked - sum.played as u64 {
        0 => String::new(),
        missing => format!(", {missing} not played to the end"),
    };
    console.print_row(
        "games",
        &format!("{}{missing}   {seeds}, {} threads, {:.1} s", sum.played, wall.threads, wall.real_s),
    )?;
    console.print_row("goals", &console.styled(style, &format!("{} of {} ({percent:.0} %)", sum.goals, sum.played)))?;
    let times = sum.time_to_goal_s.as_ref().map_or_else(
        || "-".to_owned(),
        |Times { min, p50, p90, max }| format!("p50 {p50:.1} s  p90 {p90:.1} s  (from {min:.1} to {max:.1} s)"),
    );
    console.print_row("time to goal", &times)?;
    console.print_row("own goals", &sum.own_goals.to_string())?;
    let which = match &sum.seeds_with_falls[..] {
        [] => String::new(),
        seeds => format!(", with the seeds {}", words(seeds)),
    };
    console.print_row("falls", &format!("{} in {} games{which}", sum.falls, sum.games_with_falls))?;
    console.print_row("latency", &latency(&wall.latency_ms))?;
    if sum.seeds_without_goal.is_empty() {
        return Ok(());
    }
    console.print_row("no goal", &format!("with the seeds {}", words(&sum.seeds_without_goal)))
}

fn words(seeds: &[u64]) -> String {
    seeds.iter().map(u64::to_string).collect::<Vec<_>>().join(" ")
}
