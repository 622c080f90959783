//! Content of a report, independent of its format.

use bica::Tree;
use bica::check::{longest_chain, steps};
use bica_player::Forward;

use crate::options::Options;
use crate::processor::Basis;
use bica_times::limits::{Row, never_ran, over_budget, over_limit};
use bica_times::measurements::{ACT, CHAIN, Measurements, SEEING, SENSE};
use bica_times::quantiles::Quantiles;

/// Content of a report; times in µs.
pub(crate) struct Report {
    /// Width and height of the images, px.
    pub(crate) size: (usize, usize),
    pub(crate) repeats: usize,
    pub(crate) cycles: usize,
    /// The components, slowest first.
    pub(crate) rows: Vec<Row>,
    /// Writing the sensor values.
    pub(crate) sense: Row,
    /// Reading the command.
    pub(crate) act: Row,
    /// The chain from sensing to acting; its budget is the largest sum that the states allow.
    pub(crate) chain: Row,
    /// The same chain in cycles with a new image.
    pub(crate) seeing: Row,
    /// Declared deadline of a cycle.
    pub(crate) deadline: f64,
    pub(crate) smaller: Option<Estimate>,
    /// Messages about exceeded limits.
    pub(crate) findings: Vec<String>,
}

/// Estimated times on a slower processor.
pub(crate) struct Estimate {
    pub(crate) clock_mhz: f64,
    pub(crate) ipc: f64,
    /// Explanation of the estimate.
    pub(crate) how: String,
    /// The whole chain in any cycle first, then the components: name, median, maximum; µs.
    pub(crate) rows: Vec<(String, f64, f64)>,
}

impl Report {
    pub(crate) fn new(options: &Options, measurements: &Measurements, basis: Option<Basis>) -> Self {
        let graph = &Forward::GRAPH;
        let budget = |us: Option<f32>| us.map(f64::from);
        let row = |name, channel, budget| Row {
            name,
            runs: measurements.minima(channel).len(),
            time: Quantiles::of(measurements.minima(channel)),
            ever: measurements.maximum(channel),
            budget,
        };
        let mut rows: Vec<Row> = graph
            .nodes
            .iter()
            .enumerate()
            .map(|(channel, node)| row(node.name, channel, budget(node.budget_us)))
            .collect();
        rows.sort_by(|a, b| slowest(b).total_cmp(&slowest(a)));
        let declared = longest_chain(graph, steps(graph)).sum;
        let mut report = Self {
            size: options.frame.size(),
            repeats: measurements.repetitions(),
            cycles: measurements.cycles(),
            rows,
            sense: row("sensing", SENSE, None),
            act: row("acting", ACT, None),
            chain: row("the whole chain", CHAIN, Some(declared)),
            seeing: row("with an image", SEEING, Some(declared)),
            deadline: f64::from(graph.budget_ms.unwrap_or(f32::INFINITY)) * 1e3,
            smaller: None,
            findings: Vec::new(),
        };
        report.smaller = basis.map(|basis| report.estimate(basis));
        report.findings = report.judge(options.loop_ms);
        report
    }

    fn judge(&self, loop_ms: Option<f64>) -> Vec<String> {
        let chain = self.chain.time.unwrap_or(Quantiles { p50: 0.0, p99: 0.0, max: 0.0 });
        let mut findings: Vec<String> = over_budget(&self.rows).chain(never_ran(&self.rows)).collect();
        findings.extend(over_limit("the slowest chain", chain.max, self.deadline));
        findings.extend(loop_ms.and_then(|ms| over_limit("the slowest of 100 chains", chain.p99, ms * 1e3)));
        let smaller = self.smaller.as_ref().and_then(|estimate| estimate.rows.first());
        findings.extend(
            smaller
                .and_then(|(_, _, max)| over_limit("the slowest chain on the slower processor", *max, self.deadline)),
        );
        findings
    }

    fn estimate(&self, basis: Basis) -> Estimate {
        match basis {
            Basis::Host { processor, per_second } => {
                let factor = per_second * 1e-6 / processor.per_us();
                let how = format!(
                    "This machine executes {:.2} instructions per ns of this loop: valgrind's count for a recording\n\
                     (benches/instructions.txt) divided by the time of the recording. So every time above is multiplied\n\
                     by {factor:.1}. The instructions are those of x86-64 with SSE2.",
                    per_second * 1e-9
                );
                let scaled = |row: &Row| {
                    let time = row.time?.times(factor);
                    Some((row.name.to_owned(), time.p50, time.max))
                };
                let rows = std::iter::once(&self.chain).chain(&self.rows).filter_map(scaled).collect();
                Estimate { clock_mhz: processor.mhz, ipc: processor.ipc, how, rows }
            }
            Basis::Firmware { processor, counted } => {
                let how =
                    "The instructions are those that the Cortex-M image executed in a game at 160x120, counted by QEMU\n\
                     (firmware/figures.txt; `cargo xtask firmware` plays the game)."
                        .to_owned();
                let rows = counted
                    .into_iter()
                    .map(|(name, median, max)| (name, median / processor.per_us(), max / processor.per_us()))
                    .collect();
                Estimate { clock_mhz: processor.mhz, ipc: processor.ipc, how, rows }
            }
        }
    }
}

fn slowest(row: &Row) -> f64 {
    row.time.map_or(0.0, |time| time.max)
}
