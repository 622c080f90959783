//! The report as JSON.
//!
//! A row is `name`, `runs`, `p50_us`, `p99_us`, `max_us`, `ever_us`, `declared_us` and `headroom`. The first three
//! times are over the minimum time of each run (`null` if the component never ran). `ever_us` is the maximum over all
//! repetitions. `headroom` is the share of the declared budget that the slowest run leaves free. The last two are
//! `null` where no budget is declared. `findings` lists what exceeds its limit; it is empty if the command succeeds.

use serde_json::{Value, json};

use crate::report::Report;
use bica_times::limits::Row;

/// Converts a report.
pub(crate) fn of(report: &Report) -> Value {
    json!({
        "schema": "bica-budget/1",
        "size": [report.size.0, report.size.1],
        "repeats": report.repeats,
        "cycles": report.cycles,
        "components": report.rows.iter().map(row).collect::<Vec<_>>(),
        "sensing": row(&report.sense),
        "acting": row(&report.act),
        "chain": row(&report.chain),
        "chain_with_image": row(&report.seeing),
        "deadline_us": report.deadline,
        "smaller": report.smaller.as_ref().map(|estimate| json!({
            "clock_mhz": estimate.clock_mhz,
            "ipc": estimate.ipc,
            "how": estimate.how,
            "rows": estimate.rows.iter().map(|(name, median, max)| {
                json!({ "name": name, "p50_us": median, "max_us": max })
            }).collect::<Vec<_>>(),
        })),
        "findings": report.findings,
    })
}

fn row(row: &Row) -> Value {
    json!({
        "name": row.name,
        "runs": row.runs,
        "p50_us": row.time.map(|time| time.p50),
        "p99_us": row.time.map(|time| time.p99),
        "max_us": row.time.map(|time| time.max),
        "ever_us": row.ever,
        "declared_us": row.budget,
        "headroom": row.headroom(),
    })
}
