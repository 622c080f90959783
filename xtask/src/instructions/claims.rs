//! Claims about the framework's cost in instructions. They are checked independently of the committed counts.

use std::collections::BTreeMap;

/// Largest accepted deviation from ten times the cost, for ten times as many components.
const LINEAR: f64 = 0.15;
/// Largest accepted deviation between ten active components alone and with ninety latent ones. The limit in time is 10
/// %, which `cargo xtask peers` checks. In instructions the larger program has three calls that the compiler inlines in
/// the smaller one.
const LATENT: f64 = 0.15;
/// Largest accepted deviation of a tree with parameters that is not tunable.
const UNTUNABLE: f64 = 0.005;
/// First word of the line of a claim that holds.
pub(super) const PASS: &str = "pass";

/// Claim: `large` costs `times` as much as `small`, within `tolerance`.
struct Claim {
    text: &'static str,
    small: &'static str,
    large: &'static str,
    times: f64,
    tolerance: f64,
}

/// Largest accepted additional cost of a tree whose parameters can be changed.
const TUNABLE: f64 = 0.03;

const CLAIMS: [Claim; 5] = [
    Claim {
        text: "a hundred components in ten chains cost ten times ten",
        small: "ten.cycles",
        large: "a_hundred.cycles",
        times: 10.0,
        tolerance: LINEAR,
    },
    Claim {
        text: "a chain of a hundred components costs ten times a chain of ten",
        small: "chain_of_ten.cycles",
        large: "chain_of_a_hundred.cycles",
        times: 10.0,
        tolerance: LINEAR,
    },
    Claim {
        text: "ten active components among ninety latent ones cost what they do alone",
        small: "ten_of_ten.cycles",
        large: "ten_of_a_hundred.cycles",
        times: 1.0,
        tolerance: LATENT,
    },
    Claim {
        text: "a tree with parameters that is not tunable costs what it costs with constants",
        small: "constants.cycles",
        large: "tuned_off.cycles",
        times: 1.0,
        tolerance: UNTUNABLE,
    },
    Claim {
        text: "the tunable forward costs what the forward with constants costs",
        small: "forward.at_160x120",
        large: "tunable_forward.at_160x120",
        times: 1.0,
        tolerance: TUNABLE,
    },
];

/// Returns one line for each claim.
///
/// # Errors
/// The same lines, if a claim does not hold or was not counted.
pub(crate) fn judge(counted: &BTreeMap<String, u64>) -> Result<String, String> {
    let found: Vec<(bool, String)> = CLAIMS.iter().map(|claim| line(claim, counted)).collect();
    let lines = found.iter().map(|(_, line)| line.as_str()).collect::<Vec<_>>().join("\n");
    if found.iter().all(|(holds, _)| *holds) { Ok(lines) } else { Err(format!("a claim does not hold:\n{lines}")) }
}

fn line(claim: &Claim, counted: &BTreeMap<String, u64>) -> (bool, String) {
    let Claim { text, small, large, times, tolerance } = claim;
    let limit = 100.0 * tolerance;
    let (Some(&less), Some(&more)) = (counted.get(*small), counted.get(*large)) else {
        return (false, format!("FAIL  {text}: `{small}` or `{large}` was not counted"));
    };
    let off = more as f64 / (times * less as f64) - 1.0;
    let holds = off.abs() <= *tolerance;
    let word = if holds { PASS } else { "FAIL" };
    (holds, format!("{word}  {text}, ±{limit:.1} % of instructions: {:+.1} %", 100.0 * off))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts with which every claim holds, with one of them replaced.
    fn with(name: &str, count: u64) -> BTreeMap<String, u64> {
        let mut counted: BTreeMap<String, u64> = CLAIMS
            .iter()
            .flat_map(|claim| [(claim.small.to_owned(), 1000), (claim.large.to_owned(), (1000.0 * claim.times) as u64)])
            .collect();
        counted.insert(name.to_owned(), count);
        counted
    }

    #[test]
    fn claims_that_hold_are_listed() {
        let found = judge(&with("walk", 1));
        assert!(found.is_ok_and(|lines| lines.lines().count() == CLAIMS.len() && lines.contains("+0.0 %")));
    }

    #[test]
    fn each_claim_can_fail() {
        assert!(judge(&with("a_hundred.cycles", 11_490)).is_ok());
        assert!(judge(&with("a_hundred.cycles", 11_510)).is_err());
        assert!(judge(&with("chain_of_a_hundred.cycles", 8_400)).is_err());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_149)).is_ok());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_151)).is_err_and(|text| text.contains("FAIL  ten active")));
    }

    #[test]
    fn a_claim_that_was_not_counted_fails() {
        assert!(judge(&BTreeMap::new()).is_err());
    }
}
