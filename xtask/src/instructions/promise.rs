//! What is promised of the framework's cost, in instructions: no figure of yesterday excuses breaking it.

use std::collections::BTreeMap;

/// A hundred components cost ten times what ten do, but for so much.
const LINEAR: f64 = 0.15;
/// Ten active components cost the same among ninety that are latent, but for so much. In time it is 10 %, which
/// `cargo xtask peers` holds; in instructions there are the three calls that the compiler makes in the larger program where
/// it makes one function of the smaller.
const LATENT: f64 = 0.15;
/// What the line of a promise that is kept begins with.
pub(super) const KEPT: &str = "pass";

/// A promise: what the second takes is so many times what the first does.
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

/// What was found of each promise, a line each.
///
/// # Errors
/// The same lines, if one is broken or was not counted.
pub(crate) fn judge(counted: &BTreeMap<String, u64>) -> Result<String, String> {
    let found: Vec<(bool, String)> = PROMISES.iter().map(|promise| line(promise, counted)).collect();
    let lines = found.iter().map(|(_, line)| line.as_str()).collect::<Vec<_>>().join("\n");
    if found.iter().all(|(holds, _)| *holds) { Ok(lines) } else { Err(format!("a promise is broken:\n{lines}")) }
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

    /// Counts that keep every promise, with one of them changed.
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
    fn what_is_kept_is_told() {
        let found = judge(&with("walk", 1));
        assert!(found.is_ok_and(|lines| lines.lines().count() == PROMISES.len() && lines.contains("+0.0 %")));
    }

    #[test]
    fn each_promise_can_be_broken() {
        assert!(judge(&with("a_hundred.cycles", 11_490)).is_ok());
        assert!(judge(&with("a_hundred.cycles", 11_510)).is_err());
        assert!(judge(&with("chain_of_a_hundred.cycles", 8_400)).is_err());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_149)).is_ok());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_151)).is_err_and(|text| text.contains("FAIL  ten active")));
    }

    #[test]
    fn what_was_not_counted_is_not_kept() {
        assert!(judge(&BTreeMap::new()).is_err());
    }
}
