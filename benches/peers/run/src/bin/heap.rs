//! Counts heap allocations: a line `way<tab>work<tab>allocations per cycle` for each.

use allocation_counter::measure;
use peers_run::cases;

/// Before counting, so that what grows once has grown.
const WARM: u64 = 1000;
/// Counted.
const CYCLES: u64 = 10_000;

fn main() -> Result<(), String> {
    for mut trial in cases::all(false)? {
        trial.run(WARM);
        let counted = measure(|| trial.run(CYCLES));
        println!("{}\t{}\t{}", trial.way.name(), trial.work.name(), counted.count_total as f64 / CYCLES as f64);
    }
    Ok(())
}
