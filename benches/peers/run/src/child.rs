//! A process that measures times: all cases in turn, for several rounds, pinned to one core.

use std::collections::BTreeMap;

use peers::part::combine;
use peers::report::figures::Workload;
use peers_run::case::Case;
use peers_run::cases;

/// Option of a process that measures times; the number of rounds follows it.
pub(crate) const OPTION: &str = "--rounds";

/// Duration of a batch of cycles, ns. It is short, so that some batches are not interrupted.
const BATCH_NS: f64 = 40_000.0;
/// Number of cycles whose results are compared.
const COMPARED: u64 = 1000;

/// Measures all cases for `rounds` rounds and prints a line `design<tab>workload<tab>ns` for each.
///
/// # Errors
/// If two designs compute different results.
pub(crate) fn run(rounds: usize, slow: bool) -> Result<(), String> {
    pin();
    let mut cases = cases::all(slow)?;
    compare(&mut cases)?;
    let batches: Vec<u64> = cases.iter_mut().map(|case| (BATCH_NS / rough_time(case)).clamp(1.0, 1e6) as u64).collect();
    let mut times = vec![f64::MAX; cases.len()];
    for round in 0..rounds {
        for offset in 0..cases.len() {
            let at = (round + offset) % cases.len();
            times[at] = times[at].min(cases[at].time(batches[at]));
        }
    }
    for (case, ns) in cases.iter().zip(times) {
        println!("{}\t{}\t{ns}", case.design.name(), case.workload.name());
    }
    Ok(())
}

/// Estimates the time of a cycle, ns.
fn rough_time(case: &mut Case) -> f64 {
    (0..20).map(|_| case.time(10)).fold(f64::MAX, f64::min).max(1.0)
}

/// Checks that all designs compute the same results for a workload, cycle by cycle.
fn compare(cases: &mut [Case]) -> Result<(), String> {
    let mut results = BTreeMap::<Workload, (&str, u64)>::new();
    for case in cases {
        let name = case.design.name();
        let result = (0..COMPARED).fold(0, |sum, _| {
            case.run(1);
            combine(sum, [case.result()])
        });
        let &mut (other, expected) = results.entry(case.workload).or_insert((name, result));
        if result != expected {
            return Err(format!("{}: {name} computes {result}, {other} computes {expected}", case.workload.name()));
        }
    }
    Ok(())
}

/// Pins the thread to the last core that it may use, because interrupts are usually handled by the first.
fn pin() {
    let pinned = core_affinity::get_core_ids()
        .and_then(|cores| cores.last().copied())
        .is_some_and(core_affinity::set_for_current);
    if !pinned {
        eprintln!("peers: this system cannot pin a thread to one core; times will vary more");
    }
}
