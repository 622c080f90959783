//! Test of the checks themselves: with an artificial slowdown each check must fail.

use std::collections::BTreeMap;

use super::hardest::{USUAL, VISION};
use super::{claims, gate, hardest};

/// Suffix of the benchmarks of trees. All contain the slowdown, except the hand-written one for comparison.
const TREES: &str = ".cycles";
const BY_HAND: &str = "machine_by_hand.cycles";

/// Reports of the checks for counts with the slowdown.
///
/// # Errors
/// If a check did not fail, or the committed counts cannot be read.
pub(crate) fn judge(counted: &BTreeMap<String, u64>, committed: &str, compiler: &str) -> Result<String, String> {
    let frames = || counted.keys().filter(|name| name.starts_with(VISION) && *name != USUAL);
    let trees = counted.keys().filter(|name| name.ends_with(TREES) && *name != BY_HAND);
    let hard = hardest::wrong(counted);
    let (Ok(found_claims) | Err(found_claims)) = claims::judge(counted);
    let changed = gate::compare(committed, counted, compiler)?.wrong;
    let missed: Vec<String> = [
        unreported(frames(), &hard, "not above the bound"),
        unreported(frames().chain(trees), &changed, "not reported as changed"),
        found_claims.lines().filter(|line| line.starts_with(claims::PASS)).map(str::to_owned).collect(),
    ]
    .concat();
    if !missed.is_empty() {
        return Err(format!("slowed down, but accepted:\n  {}", missed.join("\n  ")));
    }
    Ok(format!("{}\n{found_claims}\n{}\nEvery check fails, as expected.", hard.join("\n"), changed.join("\n")))
}

/// Returns the names that no line reports.
fn unreported<'a>(names: impl Iterator<Item = &'a String>, lines: &[String], what: &str) -> Vec<String> {
    let is_reported = |name: &str| lines.iter().any(|line| line.split(':').next() == Some(name));
    names.filter(|name| !is_reported(name)).map(|name| format!("{name}: {what}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 9] = [
        "a_hundred.cycles",
        "chain_of_a_hundred.cycles",
        "chain_of_ten.cycles",
        "vision.noise",
        USUAL,
        "one.cycles",
        "ten.cycles",
        "ten_of_a_hundred.cycles",
        "ten_of_ten.cycles",
    ];

    fn judged(slow: &BTreeMap<String, u64>) -> Result<String, String> {
        let committed = NAMES.map(|name| (name.to_owned(), 1000)).into();
        judge(slow, &gate::text(&committed, "rustc 1"), "rustc 1")
    }

    /// Counts ten times too high; a hundred times for benchmarks of a hundred components, hardly for one.
    fn slow() -> BTreeMap<String, u64> {
        let slow = NAMES.map(|name| (name.to_owned(), if name.contains("hundred") { 1_000_000 } else { 10_000 }));
        slow.into_iter().chain([(USUAL.to_owned(), 1000), ("one.cycles".to_owned(), 1100)]).collect()
    }

    #[test]
    fn the_test_passes_if_every_check_fails() {
        assert!(
            judged(&slow())
                .is_ok_and(|report| report.contains("vision.noise: 10.0 ×") && report.contains("FAIL  ten active"))
        );
    }

    #[test]
    fn a_check_that_passes_is_reported() {
        for (name, count, gate) in [
            ("vision.noise", 4000, "vision.noise: not above the bound"),
            ("ten_of_a_hundred.cycles", 10_000, "pass  ten active"),
            ("chain_of_a_hundred.cycles", 100_000, "pass  each further component costs the same in a chain"),
            ("ten.cycles", 1010, "ten.cycles: not reported as changed"),
        ] {
            let counted = slow().into_iter().chain([(name.to_owned(), count)]).collect();
            assert!(judged(&counted).is_err_and(|report| report.contains(gate)), "{gate}");
        }
    }
}
