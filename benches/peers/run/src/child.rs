//! One process that times: all in turn, round after round, pinned to one core.

use std::collections::BTreeMap;

use peers::part::mix;
use peers::report::figures::Work;
use peers_run::cases;
use peers_run::trial::Trial;

/// Makes a process one of these; the number of rounds follows.
pub(crate) const OPTION: &str = "--rounds";

/// How long a batch of cycles takes, ns: short, so that some fall between two interruptions.
const BATCH_NS: f64 = 40_000.0;
/// Cycles whose results are compared.
const COMPARED: u64 = 1000;

/// Times all in so many rounds and prints a line `way<tab>work<tab>ns` for each.
///
/// # Errors
/// If two come to different results.
pub(crate) fn run(rounds: usize, slow: bool) -> Result<(), String> {
    pin();
    let mut trials = cases::all(slow)?;
    compare(&mut trials)?;
    let batches: Vec<u64> = trials.iter_mut().map(|trial| (BATCH_NS / least(trial)).clamp(1.0, 1e6) as u64).collect();
    let mut times = vec![f64::MAX; trials.len()];
    for round in 0..rounds {
        for turn in 0..trials.len() {
            let at = (round + turn) % trials.len();
            times[at] = times[at].min(trials[at].time(batches[at]));
        }
    }
    for (trial, ns) in trials.iter().zip(times) {
        println!("{}\t{}\t{ns}", trial.way.name(), trial.work.name());
    }
    Ok(())
}

/// A rough time of a cycle, ns.
fn least(trial: &mut Trial) -> f64 {
    (0..20).map(|_| trial.time(10)).fold(f64::MAX, f64::min).max(1.0)
}

/// All who do the same work come to the same results, cycle by cycle.
fn compare(trials: &mut [Trial]) -> Result<(), String> {
    let mut results = BTreeMap::<Work, (&str, u64)>::new();
    for trial in trials {
        let name = trial.way.name();
        let result = (0..COMPARED).fold(0, |sum, _| {
            trial.run(1);
            mix(sum, [trial.result()])
        });
        let &mut (other, expected) = results.entry(trial.work).or_insert((name, result));
        if result != expected {
            return Err(format!("{}: {name} comes to {result}, {other} to {expected}", trial.work.name()));
        }
    }
    Ok(())
}

/// Stays on the core where it is now allowed last: interrupts prefer the first.
fn pin() {
    let pinned = core_affinity::get_core_ids()
        .and_then(|cores| cores.last().copied())
        .is_some_and(core_affinity::set_for_current);
    if !pinned {
        eprintln!("peers: this system does not let a thread stay on one core; expect more noise");
    }
}
