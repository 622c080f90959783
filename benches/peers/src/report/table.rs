//! The table, in Markdown.

use std::collections::BTreeMap;

use super::claim::Verdict;
use super::figures::{Figures, Way, Work};

/// The works that all ways are asked for.
const WORKS: [Work; 6] = [Work::Chain3, Work::Chain10, Work::Chain100, Work::Diamond, Work::Machine, Work::Forward];

/// The works that show what more components cost; ours alone does them.
const GROWING: [Work; 4] = [Work::Tree10, Work::Tree100, Work::Active, Work::Latent];

/// Least times of a cycle and, in brackets, how many times ours.
#[must_use]
pub fn times(figures: &Figures) -> String {
    let cell = |way, work| {
        let ns = figures.times.get(&(way, work))?;
        let ratio = figures.ratio((way, work), (Way::Bica, work));
        let ratio = ratio.filter(|_| way != Way::Bica).map_or_else(String::new, |ratio| format!(" ({ratio:.1} x)"));
        Some(format!("{}{ratio}", short(*ns)))
    };
    table("ns per cycle (times BICA's)", cell)
}

/// What ours takes with more components, active or latent: nanoseconds of a cycle.
#[must_use]
pub fn growth(figures: &Figures) -> String {
    let cell = |way, work| figures.times.get(&(way, work)).map(|&ns| short(ns));
    table_of("ns per cycle, as trees grow", &GROWING, cell)
}

/// Heap allocations of a cycle.
#[must_use]
pub fn heap(figures: &Figures) -> String {
    table("heap allocations per cycle", |way, work| figures.heap.get(&(way, work)).map(|&count| short(count)))
}

/// What a program grows by.
#[must_use]
pub fn sizes(figures: &Figures) -> String {
    let cell = |way, work| figures.sizes.get(&(way, work)).map(|&bytes| format!("{:.1}", bytes as f64 / 1024.0));
    table("KiB of program over an empty one", cell)
}

/// What was promised, and whether it holds.
#[must_use]
pub fn verdicts(verdicts: &[Verdict]) -> String {
    let line = |verdict: &Verdict| {
        let word = if verdict.holds { "pass" } else { "FAIL" };
        format!("{word}  {}: {}\n", verdict.claim, verdict.found)
    };
    verdicts.iter().map(line).collect()
}

/// A row for each way and a column for each of the works that all are asked for, as far as there is anything.
fn table(title: &str, cell: impl Fn(Way, Work) -> Option<String>) -> String {
    table_of(title, &WORKS, cell)
}

fn table_of(title: &str, works: &[Work], cell: impl Fn(Way, Work) -> Option<String>) -> String {
    let mut cells = BTreeMap::new();
    for &way in Way::ALL {
        for &work in works {
            if let Some(text) = cell(way, work) {
                cells.insert((way, work), text);
            }
        }
    }
    let works: Vec<Work> = works.iter().copied().filter(|work| cells.keys().any(|(_, with)| with == work)).collect();
    let ways = Way::ALL.iter().filter(|way| cells.keys().any(|(with, _)| with == *way));
    let mut rows = vec![vec![title.to_owned()]];
    rows[0].extend(works.iter().map(|work| work.name().to_owned()));
    for &way in ways {
        let cell = |work: &Work| cells.get(&(way, *work)).cloned().unwrap_or_default();
        rows.push([way.name().to_owned()].into_iter().chain(works.iter().map(cell)).collect());
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

/// Two or three figures.
fn short(figure: f64) -> String {
    match figure {
        0.0 => "0".to_owned(),
        _ if figure < 1.0 => format!("{figure:.2}"),
        _ if figure < 100.0 => format!("{figure:.1}"),
        _ => format!("{figure:.0}"),
    }
}
