//! All that a report says, before it is put in words.

use bica::Tree;
use bica::check::{longest_chain, steps};
use bica_player::Forward;

use crate::options::Options;
use crate::smaller::Machine;
use bica_benches::budget::lanes::{ACT, CHAIN, Lanes, SEEING, SENSE};
use bica_benches::budget::spread::Spread;
use bica_benches::budget::verdict::{Row, broken, idle, late};

/// All that a report says. µs where nothing else is said.
pub(crate) struct Report {
    /// Of the images, pixels.
    pub(crate) size: (usize, usize),
    pub(crate) repeats: usize,
    pub(crate) cycles: usize,
    /// The components, the slowest first.
    pub(crate) rows: Vec<Row>,
    /// Taking the sensors in.
    pub(crate) sense: Row,
    /// Telling the motors.
    pub(crate) act: Row,
    /// From sensing to acting, with the largest sum of budgets that the states allow.
    pub(crate) chain: Row,
    /// The same in the cycles with a new image.
    pub(crate) seeing: Row,
    /// What the tree declares for a cycle.
    pub(crate) deadline: f64,
    pub(crate) smaller: Option<Estimate>,
    /// What does not hold.
    pub(crate) findings: Vec<String>,
}

/// What a smaller robot would take.
pub(crate) struct Estimate {
    pub(crate) clock_mhz: f64,
    pub(crate) ipc: f64,
    /// How the figures were made.
    pub(crate) how: String,
    /// The whole chain first, in any cycle, then the components: name, median, most.
    pub(crate) rows: Vec<(String, f64, f64)>,
}

impl Report {
    pub(crate) fn new(options: &Options, played: &Lanes, machine: Option<Machine>) -> Self {
        let graph = &Forward::GRAPH;
        let budget = |us: Option<f32>| us.map(f64::from);
        let row = |name, lane, budget| Row {
            name,
            runs: played.least(lane).len(),
            time: Spread::of(played.least(lane)),
            most: played.most(lane),
            budget,
        };
        let mut rows: Vec<Row> =
            graph.nodes.iter().enumerate().map(|(lane, node)| row(node.name, lane, budget(node.budget_us))).collect();
        rows.sort_by(|a, b| slowest(b).total_cmp(&slowest(a)));
        let declared = longest_chain(graph, steps(graph)).sum;
        let mut report = Self {
            size: options.frame.size(),
            repeats: played.games(),
            cycles: played.cycles(),
            rows,
            sense: row("sensing", SENSE, None),
            act: row("acting", ACT, None),
            chain: row("the whole chain", CHAIN, Some(declared)),
            seeing: row("with an image", SEEING, Some(declared)),
            deadline: f64::from(graph.budget_ms.unwrap_or(f32::INFINITY)) * 1e3,
            smaller: None,
            findings: Vec::new(),
        };
        report.smaller = machine.map(|machine| report.estimate(machine));
        report.findings = report.judge(options.loop_ms);
        report
    }

    fn judge(&self, loop_ms: Option<f64>) -> Vec<String> {
        let chain = self.chain.time.unwrap_or(Spread { p50: 0.0, p99: 0.0, max: 0.0 });
        let mut findings: Vec<String> = broken(&self.rows).chain(idle(&self.rows)).collect();
        findings.extend(late("the slowest chain", chain.max, self.deadline));
        findings.extend(loop_ms.and_then(|ms| late("the slowest of 100 chains", chain.p99, ms * 1e3)));
        let smaller = self.smaller.as_ref().and_then(|estimate| estimate.rows.first());
        findings.extend(
            smaller.and_then(|(_, _, max)| late("the slowest chain on the smaller robot", *max, self.deadline)),
        );
        findings
    }

    fn estimate(&self, machine: Machine) -> Estimate {
        match machine {
            Machine::Host { asked, per_second } => {
                let factor = per_second * 1e-6 / asked.per_us();
                let how = format!(
                    "This machine executes {:.2} instructions in a ns of this loop: as many as valgrind counts in a \
                     recording\n(benches/instructions.txt), by the time that the recording takes. So every time above \
                     is taken {factor:.1} times.\nThe instructions are those of x86-64 with SSE2.",
                    per_second * 1e-9
                );
                let scaled = |row: &Row| {
                    let time = row.time?.times(factor);
                    Some((row.name.to_owned(), time.p50, time.max))
                };
                let rows = std::iter::once(&self.chain).chain(&self.rows).filter_map(scaled).collect();
                Estimate { clock_mhz: asked.mhz, ipc: asked.ipc, how, rows }
            }
            Machine::Firmware { asked, counted } => {
                let how =
                    "The instructions are those that the Cortex-M image executed in a game at 160x120, counted by \
                           QEMU\n(firmware/figures.txt; `cargo xtask firmware` plays it)."
                        .to_owned();
                let rows = counted
                    .into_iter()
                    .map(|(name, median, max)| (name, median / asked.per_us(), max / asked.per_us()))
                    .collect();
                Estimate { clock_mhz: asked.mhz, ipc: asked.ipc, how, rows }
            }
        }
    }
}

fn slowest(row: &Row) -> f64 {
    row.time.map_or(0.0, |time| time.max)
}
