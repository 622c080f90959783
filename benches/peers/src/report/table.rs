//! Tables in Markdown.

use std::collections::BTreeMap;

use super::claim::Verdict;
use super::figures::{Design, Figures, Workload};

/// Workloads of all designs with empty steps.
const WORKLOADS: [Workload; 6] =
    [Workload::Chain3, Workload::Chain10, Workload::Chain100, Workload::Diamond, Workload::Machine, Workload::Forward];

/// Workloads with steps of realistic size.
const SIZED: [Workload; 3] = [Workload::SizedChain10, Workload::SizedMachine, Workload::SizedForward];

/// Workloads that show the growth of the cost with the number of components; only BICA runs them.
const GROWING: [Workload; 4] = [Workload::Tree10, Workload::Tree100, Workload::Active, Workload::Latent];

/// Minimum times of a cycle and, in brackets, the ratio to BICA's time.
#[must_use]
pub fn times(figures: &Figures) -> String {
    times_of(figures, "ns per cycle (times BICA's)", &WORKLOADS)
}

/// The same with steps of realistic size.
#[must_use]
pub fn sized_times(figures: &Figures) -> String {
    times_of(figures, "steps of 20 ns: ns per cycle (times BICA's)", &SIZED)
}

fn times_of(figures: &Figures, title: &str, workloads: &[Workload]) -> String {
    let cell = |design, workload| {
        let ns = figures.times.get(&(design, workload))?;
        let ratio = figures.ratio((design, workload), (Design::Bica, workload));
        let ratio =
            ratio.filter(|_| design != Design::Bica).map_or_else(String::new, |ratio| format!(" ({ratio:.2} x)"));
        Some(format!("{}{ratio}", short(*ns)))
    };
    table_of(title, workloads, cell)
}

/// Times of a cycle of BICA for growing trees, ns.
#[must_use]
pub fn growth(figures: &Figures) -> String {
    let cell = |design, workload| figures.times.get(&(design, workload)).map(|&ns| short(ns));
    table_of("steps of 20 ns: ns per cycle, as trees grow", &GROWING, cell)
}

/// Heap allocations per cycle.
#[must_use]
pub fn heap(figures: &Figures) -> String {
    table("heap allocations per cycle", |design, workload| {
        figures.heap.get(&(design, workload)).map(|&count| short(count))
    })
}

/// Program sizes.
#[must_use]
pub fn sizes(figures: &Figures) -> String {
    let cell =
        |design, workload| figures.sizes.get(&(design, workload)).map(|&bytes| format!("{:.1}", bytes as f64 / 1024.0));
    table("KiB of program over an empty one", cell)
}

/// Claims and whether they hold.
#[must_use]
pub fn verdicts(verdicts: &[Verdict]) -> String {
    let line = |verdict: &Verdict| {
        let word = if verdict.holds { "pass" } else { "FAIL" };
        format!("{word}  {}: {}\n", verdict.claim, verdict.found)
    };
    verdicts.iter().map(line).collect()
}

/// Table with a row for each design and a column for each workload; rows and columns without figures are left out.
fn table(title: &str, cell: impl Fn(Design, Workload) -> Option<String>) -> String {
    table_of(title, &WORKLOADS, cell)
}

fn table_of(title: &str, workloads: &[Workload], cell: impl Fn(Design, Workload) -> Option<String>) -> String {
    let mut cells = BTreeMap::new();
    for &design in Design::ALL {
        for &workload in workloads {
            if let Some(text) = cell(design, workload) {
                cells.insert((design, workload), text);
            }
        }
    }
    let workloads: Vec<Workload> =
        workloads.iter().copied().filter(|workload| cells.keys().any(|(_, with)| with == workload)).collect();
    let ways = Design::ALL.iter().filter(|design| cells.keys().any(|(with, _)| with == *design));
    let mut rows = vec![vec![title.to_owned()]];
    rows[0].extend(workloads.iter().map(|workload| workload.name().to_owned()));
    for &design in ways {
        let cell = |workload: &Workload| cells.get(&(design, *workload)).cloned().unwrap_or_default();
        rows.push([design.name().to_owned()].into_iter().chain(workloads.iter().map(cell)).collect());
    }
    markdown(&rows)
}

fn markdown(rows: &[Vec<String>]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default();
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    let rule: Vec<String> = widths.iter().enumerate().map(|(at, &width)| dashes(width, at > 0)).collect();
    let line = |cells: &Vec<String>| {
        let cells = cells.iter().zip(&widths).enumerate();
        let padded = cells
            .map(|(at, (cell, &width))| if at == 0 { format!("{cell:width$}") } else { format!("{cell:>width$}") });
        format!("| {} |\n", padded.collect::<Vec<_>>().join(" | "))
    };
    [line(&rows[0]), line(&rule)].into_iter().chain(rows[1..].iter().map(line)).collect()
}

fn dashes(width: usize, right: bool) -> String {
    if right { format!("{}:", "-".repeat(width - 1)) } else { "-".repeat(width) }
}

/// Formats a number with two or three significant digits.
fn short(figure: f64) -> String {
    match figure {
        0.0 => "0".to_owned(),
        _ if figure < 1.0 => format!("{figure:.2}"),
        _ if figure < 100.0 => format!("{figure:.1}"),
        _ => format!("{figure:.0}"),
    }
}
