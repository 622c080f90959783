//! Many games on all cores.

use std::num::NonZero;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::Instant as Clock;

use super::album::Album;
use super::game_loop::{Rules, play};
use super::series_summary::{self, Series};
use super::summary::{GameResult, Record};
use bica_console::Console;
use bica_console::Progress;
use bica_console::{Failure, Outcome};
use bica_console::{STACK, interrupt};

/// How many games, and on how many threads.
pub struct Plan {
    games: u64,
    threads: usize,
    /// Games with a goal that make the series a success.
    wanted: usize,
}

impl Plan {
    /// One thread for each core, and every game won, if nothing else is said.
    pub fn new(games: u32, threads: Option<u32>, wanted: Option<u32>) -> Self {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let threads = threads.map_or(cores, |threads| threads as usize);
        Self { games: games.into(), threads: threads.min(games as usize), wanted: wanted.unwrap_or(games) as usize }
    }
}

/// Plays them, sums them up.
pub fn run(rules: &Rules, console: Console, pictures: Option<&Path>, plan: &Plan) -> Result<Outcome, Failure> {
    let began = Clock::now();
    let records = play_all(rules, pictures, plan)?;
    let real_s = began.elapsed().as_secs_f64();
    let series = Series::new(rules.seed, plan.games, records, plan.threads, real_s);
    series_summary::tell(console, &series)?;
    console.print_json(&series)?;
    Ok(if interrupt::requested() {
        Outcome::Interrupted
    } else if series.goals() >= plan.wanted {
        Outcome::Success
    } else {
        Outcome::Unsuccessful
    })
}

/// The games that were played to their end, in the order of their seeds.
fn play_all(rules: &Rules, pictures: Option<&Path>, plan: &Plan) -> Result<Vec<Record>, Failure> {
    let (next, (sender, receiver)) = (AtomicU64::new(0), mpsc::channel());
    thread::scope(|scope| {
        for _ in 0..plan.threads {
            let (next, sender) = (&next, sender.clone());
            thread::Builder::new()
                .stack_size(STACK)
                .spawn_scoped(scope, move || work(rules, pictures, plan.games, next, &sender))
                .map_err(|error| Failure::new(format!("cannot start a thread: {error}"), "try fewer --threads"))?;
        }
        drop(sender);
        collect(receiver, plan.games)
    })
}

/// Plays the next game that nobody plays, until there is none, nobody waits for it, or Ctrl-C.
fn work(
    rules: &Rules,
    pictures: Option<&Path>,
    games: u64,
    next: &AtomicU64,
    sender: &Sender<Result<Record, Failure>>,
) {
    loop {
        let game = next.fetch_add(1, Ordering::Relaxed);
        if game >= games || interrupt::requested() {
            return;
        }
        let rules = Rules { seed: rules.seed.wrapping_add(game), ..*rules };
        let album = pictures.map(|folder| Album::new(&folder.join(format!("seed-{}", rules.seed)))).transpose();
        let record = album.and_then(|mut album| play(&rules, &mut album));
        if sender.send(record).is_err() {
            return;
        }
    }
}

fn collect(receiver: Receiver<Result<Record, Failure>>, games: u64) -> Result<Vec<Record>, Failure> {
    let mut progress = Progress::new(games);
    let mut records = Vec::new();
    for record in receiver {
        let record = record?;
        if record.result != GameResult::Interrupted {
            progress.step(record.result == GameResult::Goal);
            records.push(record);
        }
    }
    records.sort_by_key(|record| record.seed);
    Ok(records)
}
