//! Counts heap allocations; prints a line `design<tab>workload<tab>allocations per cycle` for each case.

/// Cycles before the count, so that containers have reached their final capacity.
const WARM: u64 = 1000;
/// Cycles during the count.
const CYCLES: u64 = 10_000;

fn main() -> Result<(), String> {
    for mut case in peers::cases::all(false)? {
        case.run(WARM);
        let counted = allocation_counter::measure(|| case.run(CYCLES));
        println!("{}\t{}\t{}", case.design, case.workload, counted.count_total as f64 / CYCLES as f64);
    }
    Ok(())
}
