//! Compares the results of all cases, and times the cases in turn; `benches/scripts/peers.py` runs it.
//!
//! The first argument is the number of rounds. With `slow` as the second, BICA contains an artificial slowdown. The program prints
//! a line `design<tab>workload<tab>ns per cycle` for each case.

use peers::case::{Case, compare};
use peers::cases;

/// Duration of a batch of cycles, ns. It is short, so that some batches are not interrupted.
const BATCH_NS: f64 = 40_000.0;
/// Number of cycles whose results are compared.
const COMPARED: u64 = 1000;

fn main() -> Result<(), String> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let rounds: usize = words.first().and_then(|word| word.parse().ok()).ok_or("usage: peers ROUNDS [slow]")?;
    let mut cases = cases::all(words.get(1).is_some_and(|word| word == "slow"))?;
    compare(&mut cases, COMPARED)?;
    if rounds == 0 {
        return Ok(());
    }
    let batches: Vec<u64> = cases.iter_mut().map(|case| (BATCH_NS / rough_time(case)).clamp(1.0, 1e6) as u64).collect();
    let mut times = vec![f64::MAX; cases.len()];
    for round in 0..rounds {
        for offset in 0..cases.len() {
            let at = (round + offset) % cases.len();
            times[at] = times[at].min(cases[at].time(batches[at]));
        }
    }
    for (case, ns) in cases.iter().zip(times) {
        println!("{}\t{}\t{ns}", case.design, case.workload);
    }
    Ok(())
}

/// Estimates the time of a cycle, ns.
fn rough_time(case: &mut Case) -> f64 {
    (0..20).map(|_| case.time(10)).fold(f64::MAX, f64::min).max(1.0)
}
