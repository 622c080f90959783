//! Comparison of instruction counts with the committed ones.

use std::collections::BTreeMap;
use std::fmt::Write;

/// Largest accepted relative change of a count.
const TOLERANCE: f64 = 0.02;
/// Largest accepted absolute change; smaller changes come from code generation.
const GRAIN: u64 = 4;

const HEADING: &str = "# Instructions, counted by valgrind. `cargo xtask budget --bless` writes this file.\n";
const COMPILER: &str = "# Compiler: ";

/// Result of a comparison.
pub(crate) struct Report {
    /// All counts with their changes.
    pub(crate) table: String,
    /// Message for each count that changed, is new, or is missing.
    pub(crate) wrong: Vec<String>,
}

/// Formats counts as the content of the file.
pub(crate) fn text(counted: &BTreeMap<String, u64>, compiler: &str) -> String {
    let mut text = format!("{HEADING}{COMPILER}{compiler}\n");
    for (name, count) in counted {
        let _ = writeln!(text, "{name} {count}");
    }
    text
}

/// Compares counts with those of a file.
///
/// # Errors
/// If a line of the file is not a name and a count.
pub(crate) fn compare(text: &str, counted: &BTreeMap<String, u64>, compiler: &str) -> Result<Report, String> {
    let known = read(text)?;
    let (mut table, mut wrong) = (String::new(), Vec::new());
    for (name, &now) in counted {
        let before = known.get(name).copied();
        let change = before.map_or(String::new(), |before| format!("{:+.2} %", percent(now, before)));
        let _ = writeln!(table, "{name:<32}{now:>12}{change:>12}");
        match before {
            None => wrong.push(format!("{name}: new, {now} instructions")),
            Some(before) if !is_near(now, before) => {
                wrong.push(format!("{name}: {before} instructions before, {now} now, {change}"));
            }
            Some(_) => {}
        }
    }
    let gone = known.keys().filter(|name| !counted.contains_key(*name));
    wrong.extend(gone.map(|name| format!("{name}: no longer counted")));
    let before = text.lines().find_map(|line| line.strip_prefix(COMPILER)).unwrap_or("unknown");
    if !wrong.is_empty() && before != compiler {
        wrong.push(format!("the compiler changed: {before} before, {compiler} now"));
    }
    Ok(Report { table, wrong })
}

fn read(text: &str) -> Result<BTreeMap<String, u64>, String> {
    let line = |line: &str| {
        let (name, count) = line.split_once(' ')?;
        Some((name.to_owned(), count.parse().ok()?))
    };
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|words| line(words).ok_or_else(|| format!("`{words}` is not a name and a count"))).collect()
}

fn is_near(now: u64, before: u64) -> bool {
    now.abs_diff(before) as f64 <= (TOLERANCE * before as f64).max(GRAIN as f64)
}

fn percent(now: u64, before: u64) -> f64 {
    100.0 * (now as f64 / before as f64 - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(pairs: &[(&str, u64)]) -> BTreeMap<String, u64> {
        pairs.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect()
    }

    fn wrong(before: &[(&str, u64)], now: &[(&str, u64)]) -> Vec<String> {
        compare(&text(&counts(before), "rustc 1"), &counts(now), "rustc 1").expect("a sound file").wrong
    }

    #[test]
    fn changes_up_to_two_percent_are_accepted() {
        assert!(wrong(&[("walk", 1000)], &[("walk", 1000)]).is_empty());
        assert!(wrong(&[("walk", 1000)], &[("walk", 1020)]).is_empty());
        assert!(wrong(&[("walk", 1000)], &[("walk", 980)]).is_empty());
        assert!(wrong(&[("eye", 92)], &[("eye", 96)]).is_empty());
    }

    #[test]
    fn a_count_that_rises_by_more_is_reported() {
        let wrong = wrong(&[("ball", 500), ("walk", 1000)], &[("ball", 500), ("walk", 1021)]);
        assert_eq!(wrong, ["walk: 1000 instructions before, 1021 now, +2.10 %"]);
    }

    #[test]
    fn a_count_that_falls_by_more_is_reported_too() {
        assert_eq!(wrong(&[("walk", 1000)], &[("walk", 900)]).len(), 1);
    }

    #[test]
    fn new_and_missing_benchmarks_are_reported() {
        let wrong = wrong(&[("old", 1)], &[("new", 1)]);
        assert_eq!(wrong, ["new: new, 1 instructions", "old: no longer counted"]);
    }

    #[test]
    fn a_changed_compiler_is_reported_with_the_changed_counts() {
        let text = text(&counts(&[("walk", 1000)]), "rustc 1");
        let wrong = |now| compare(&text, &counts(&[("walk", now)]), "rustc 2").expect("a sound file").wrong;
        assert!(wrong(1000).is_empty());
        assert_eq!(wrong(2000)[1], "the compiler changed: rustc 1 before, rustc 2 now");
    }

    #[test]
    fn a_line_without_a_count_is_refused() {
        assert!(compare("walk many\n", &BTreeMap::new(), "").is_err());
    }
}
