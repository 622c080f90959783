//! The report as a table.

use std::fmt::Write;

use crate::report::{Estimate, Report};
use bica_times::limits::Row;

/// Formats a report.
pub(crate) fn of(report: &Report) -> String {
    let (width, height) = report.size;
    let mut text = format!(
        "{} cycles of fixed games, images of {width}x{height}, {} repetitions; µs for one run, the minimum over the\n\
         repetitions. A budget must hold for the slowest run (max). `ever` is the maximum over all repetitions, with\n\
         interruptions.\n\n{:<16}{:>7}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n",
        report.cycles, report.repeats, "", "runs", "p50", "p99", "max", "ever", "declared", "headroom"
    );
    line(&mut text, &report.sense);
    for row in &report.rows {
        line(&mut text, row);
    }
    line(&mut text, &report.act);
    text.push('\n');
    line(&mut text, &report.chain);
    line(&mut text, &report.seeing);
    let took = report.chain.time.map_or(0.0, |time| time.max);
    let _ = writeln!(
        text,
        "\nfrom sensing to acting: {:.2} ms in the slowest cycle, {:.2} ms declared, {:.0} ms allowed: {:.1} % headroom",
        took * 1e-3,
        report.chain.budget.unwrap_or(0.0) * 1e-3,
        report.deadline * 1e-3,
        100.0 * (1.0 - took / report.deadline)
    );
    if let Some(estimate) = &report.smaller {
        smaller(&mut text, estimate, report.deadline);
    }
    text
}

fn line(text: &mut String, row: &Row) {
    let _ = write!(text, "{:<16}{:>7}", row.name, row.runs);
    if let Some(time) = row.time {
        let _ = write!(text, "{:>10.2}{:>10.2}{:>10.2}{:>10.2}", time.p50, time.p99, time.max, row.ever);
    }
    if let Some(budget) = row.budget {
        let _ = write!(text, "{budget:>10}");
    }
    if let Some(headroom) = row.headroom() {
        let _ = write!(text, "{:>8.0} %", 100.0 * headroom);
    }
    text.push('\n');
}

fn smaller(text: &mut String, estimate: &Estimate, deadline: f64) {
    let _ = writeln!(
        text,
        "\non {} MHz with {} instructions per clock cycle, ms for one run\n\n{:<16}{:>10}{:>10}",
        estimate.clock_mhz, estimate.ipc, "", "p50", "max"
    );
    for (name, median, max) in &estimate.rows {
        let _ = writeln!(text, "{name:<16}{:>10.3}{:>10.3}", median * 1e-3, max * 1e-3);
    }
    let slowest = estimate.rows.first().map_or(0.0, |(_, _, max)| *max);
    let _ = writeln!(
        text,
        "\n{}\nThe slowest chain {} the deadline of {:.0} ms: {:.1} ms, {:.0} % headroom.",
        estimate.how,
        if slowest > deadline { "misses" } else { "keeps" },
        deadline * 1e-3,
        slowest * 1e-3,
        100.0 * (1.0 - slowest / deadline)
    );
}
