//! Claims about the framework's cost in instructions. They are checked independently of the committed counts.

use std::collections::BTreeMap;

/// Largest accepted deviation from the cost of a component in a small tree, for one in a large tree or of many robots.
const LINEAR: f64 = 0.10;
/// The same for ten chains beside one: their root combines ten values, and the compiler folds the steps of one chain.
const WIDE: f64 = 0.30;
/// Tree of one component. Beside a component, a tick costs something by itself, which does not grow.
const ONE: &str = "one.cycles";
/// Largest accepted deviation between ten active components alone and with ninety latent ones. The limit in time is 10
/// %, which `cargo xtask peers` checks. In instructions the larger program has three calls that the compiler inlines in
/// the smaller one.
const LATENT: f64 = 0.15;
/// Largest accepted deviation of a tree with parameters that is not tunable.
const UNTUNABLE: f64 = 0.005;
/// First word of the line of a claim that holds.
pub(super) const PASS: &str = "pass";

/// Claim: `large` costs `times` as much as `small`, within `tolerance`; `without` is subtracted from both.
struct Claim {
    text: &'static str,
    small: &'static str,
    large: &'static str,
    times: f64,
    tolerance: f64,
    without: Option<&'static str>,
}

/// Largest accepted additional cost of a tree whose parameters can be changed.
const TUNABLE: f64 = 0.03;

const CLAIMS: [Claim; 7] = [
    Claim {
        text: "each further component costs the same up to a hundred in ten chains as up to ten",
        small: "ten.cycles",
        large: "a_hundred.cycles",
        times: 11.0,
        tolerance: WIDE,
        without: Some(ONE),
    },
    Claim {
        text: "each further component costs the same in a chain of a hundred as in a chain of ten",
        small: "chain_of_ten.cycles",
        large: "chain_of_a_hundred.cycles",
        times: 11.0,
        tolerance: LINEAR,
        without: Some(ONE),
    },
    Claim {
        text: "ten robots of a hundred components in one process cost ten times one",
        small: "a_hundred.cycles",
        large: "ten_robots_of_a_hundred.cycles",
        times: 10.0,
        tolerance: LINEAR,
        without: None,
    },
    Claim {
        text: "a thousand components in a hundred trees cost a hundred times ten in one",
        small: "ten.cycles",
        large: "a_hundred_robots_of_ten.cycles",
        times: 100.0,
        tolerance: LINEAR,
        without: None,
    },
    Claim {
        text: "ten active components among ninety latent ones cost what they do alone",
        small: "ten_of_ten.cycles",
        large: "ten_of_a_hundred.cycles",
        times: 1.0,
        tolerance: LATENT,
        without: None,
    },
    Claim {
        text: "a tree with parameters that is not tunable costs what it costs with constants",
        small: "constants.cycles",
        large: "tuned_off.cycles",
        times: 1.0,
        tolerance: UNTUNABLE,
        without: None,
    },
    Claim {
        text: "the tunable forward costs what the forward with constants costs",
        small: "forward.at_160x120",
        large: "tunable_forward.at_160x120",
        times: 1.0,
        tolerance: TUNABLE,
        without: None,
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
    let Claim { text, small, large, times, tolerance, without } = claim;
    let limit = 100.0 * tolerance;
    let fixed = without.map_or(Some(0), |name| counted.get(name).copied());
    let (Some(&less), Some(&more), Some(fixed)) = (counted.get(*small), counted.get(*large), fixed) else {
        return (
            false,
            format!("FAIL  {text}: `{small}`, `{large}` or `{}` was not counted", without.unwrap_or(small)),
        );
    };
    let off = (more as f64 - fixed as f64) / (times * (less as f64 - fixed as f64)) - 1.0;
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
            .flat_map(|claim| {
                let fixed = claim.without.map_or(0.0, |_| 100.0);
                let large = fixed + (1000.0 - fixed) * claim.times;
                [(claim.small.to_owned(), 1000), (claim.large.to_owned(), large as u64), (ONE.to_owned(), 100)]
            })
            .collect();
        // A large tree is the small one of another claim.
        counted.insert("ten_robots_of_a_hundred.cycles".to_owned(), 100_000);
        counted.insert("a_hundred.cycles".to_owned(), 10_000);
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
        assert!(judge(&with("a_hundred.cycles", 10_980)).is_ok());
        assert!(judge(&with("a_hundred.cycles", 12_980)).is_err());
        assert!(judge(&with("chain_of_a_hundred.cycles", 8_400)).is_err());
        assert!(judge(&with("ten_robots_of_a_hundred.cycles", 111_000)).is_err());
        assert!(judge(&with("a_hundred_robots_of_ten.cycles", 89_000)).is_err());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_149)).is_ok());
        assert!(judge(&with("ten_of_a_hundred.cycles", 1_151)).is_err_and(|text| text.contains("FAIL  ten active")));
    }

    #[test]
    fn a_claim_that_was_not_counted_fails() {
        assert!(judge(&BTreeMap::new()).is_err());
    }
}
