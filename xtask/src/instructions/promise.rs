//! Promises about the framework's cost in instructions. They hold whatever the committed counts are.

use std::collections::BTreeMap;

/// Largest accepted deviation from ten times the cost, for ten times as many components.
const LINEAR: f64 = 0.15;
/// Largest accepted deviation between ten active components alone and among ninety latent ones. In time it is 10 %, which
/// `cargo xtask peers` checks; in instructions the larger program has three calls that the compiler inlines in the smaller.
const LATENT: f64 = 0.15;
/// First word of the line of a promise that holds.
pub(super) const KEPT: &str = "pass";

/// A promise: `large` costs `times` as much as `small`, within `tolerance`.
struct Promise {
    claim: &'static str,
    small: &'static str,
    large: &'static str,
    times: f64,
    tolerance: f64,
}

const PROMISES: [Promise; 3] = [
    Promise {
        claim: "a hundred components in ten chains cost ten times ten",
        small: "ten.cycles",
        large: "a_hundred.cycles",
        times: 10.0,
        tolerance: LINEAR,
    },
    Promise {
        claim: "a chain of a hundred components costs ten times a chain of ten",
        small: "chain_of_ten.cycles",
        large: "chain_of_a_hundred.cycles",
        times: 10.0,
        tolerance: LINEAR,
    },
    Promise {
        claim: "ten active components among ninety latent ones cost what they do alone",
        small: "ten_of_ten.cycles",
        large: "ten_of_a_hundred.cycles",
        times: 1.0,
        tolerance: LATENT,
    },
];

/// One line for each promise.
///
/// # Errors
/// The same lines, if a promise does not hold or was not counted.
pub(crate) fn judge(counted: &BTreeMap<String, u64>) -> Result<String, String> {
    let found: Vec<(bool, String)> = PROMISES.iter().map(|promise| line(promise, counted)).collect();
    let lines = found.iter().map(|(_, line)| line.as_str()).collect::<Vec<_>>().join("\n");
    if found.iter().all(|(holds, _)| *holds) { Ok(lines) } else { Err(format!("a promise does not hold:\n{lines}")) }
}

fn line(promise: &Promise, counted: &BTreeMap<String, u64>) -> (bool, String) {
    let Promise { claim, small, large, times, tolerance } = promise;
    let may = 100.0 * tolerance;
    let (Some(&less), Some(&more)) = (counted.get(*small), counted.get(*large)) else {
        return (false, format!("FAIL  {claim}: `{small}` or `{large}` was not counted"));
    };
    let off = more as f64 / (times * less as f64) - 1.0;
    let holds = off.abs() <= *tolerance;
    let word = if holds { KEPT } else { "FAIL" };
    (holds, format!("{word}  {claim}, ±{may:.0} % of instructions: {:+.1} %", 100.0 * off))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts with which every promise holds, with one of them replaced.
    fn with(name: &str, count: u64) -> BTreeMap<String, u64> {
        let mut counted: BTreeMap<String, u64> = PROMISES
            .iter()
            .flat_map(|promise| {
                [(promise.small.to_owned(), 1000), (promise.large.to_owned(), (1000.0 * promise.times) as u64)]
            })
            .collect();
        counted.insert(name.to_owned(), count);
        counted
    }

    #[test]
    fn promises_that_hold_are_listed() {
        let found = judge(&with("walk", 1));
        assert!(found.is_ok_and(|lines| lines.lines().count() == PROMISES.len() && lines.contains("+0.0 %")));
    }

    #[test]
    fn each_promise_can_fail() {
        assert!(judge(&with("a_hundred.cycles", 11_490)).is_ok());
        assert!(judge(&with("a_hundred.cycles", 11_510)).is_err());
        assert!(judge(&with("chain_of_a_hundred.cycles", 8_400)).is_err());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_149)).is_ok());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_151)).is_err_and(|text| text.contains("FAIL  ten active")));
    }

    #[test]
    fn a_promise_that_was_not_counted_fails() {
        assert!(judge(&BTreeMap::new()).is_err());
    }
}
