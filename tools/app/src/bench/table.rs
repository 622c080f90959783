//! Table of a world's figures.

use std::fmt::Write;

use super::figures::{Figures, Row};

const HEADS: [&str; 7] = ["runs", "p50", "p99", "slowest", "ever", "declared", "headroom"];

/// Returns the table as text.
pub(super) fn table(figures: &Figures) -> String {
    let Figures { robot, world, deadline_ms, components, phases, .. } = figures;
    let mut text =
        format!("\n{robot} in {world}: µs for one run, the minimum over the repetitions; `ever` is the maximum");
    write(&mut text, "", &HEADS.map(str::to_owned));
    for row in components.iter().chain(phases).filter(|row| row.runs > 0 || row.declared_us.is_some()) {
        write(&mut text, row.name, &cells(row));
    }
    if let (Some(deadline), Some(chain)) = (deadline_ms, phases.last()) {
        let part = 0.1 * chain.max_us / f64::from(*deadline);
        _ = write!(text, "\nThe slowest chain takes {:.2} ms of {deadline} ms, {part:.1} %.", 1e-3 * chain.max_us);
    }
    text
}

fn write(text: &mut String, name: &str, cells: &[String; 7]) {
    _ = write!(text, "\n{name:<20}");
    for cell in cells {
        _ = write!(text, "{cell:>10}");
    }
}

fn cells(row: &Row) -> [String; 7] {
    let time = |us: f64| format!("{us:.2}");
    let headroom = row.declared_us.map(|declared| format!("{:.0} %", 100.0 * (1.0 - row.max_us / declared)));
    let declared = row.declared_us.map(time).unwrap_or_default();
    let [p50, p99, slowest, ever] = [row.p50_us, row.p99_us, row.max_us, row.ever_us].map(time);
    [row.runs.to_string(), p50, p99, slowest, ever, declared, headroom.unwrap_or_default()]
}
