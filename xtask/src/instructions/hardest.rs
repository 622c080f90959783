//! No frame may make the eyes work much harder than frames do.

use std::collections::BTreeMap;

/// Of one benchmark: rendered frames, and as many looks at each frame that is made to cost most.
pub(super) const EYES: &str = "eyes.";
pub(super) const USUAL: &str = "eyes.usual";
/// How many times as many instructions as a usual frame any other may take.
const MOST: f64 = 5.0;

/// The frames that take too many instructions, in words.
pub(crate) fn wrong(counted: &BTreeMap<String, u64>) -> Vec<String> {
    let Some(usual) = counted.get(USUAL) else { return vec![format!("{USUAL}: not counted")] };
    let times = |count: u64| count as f64 / *usual as f64;
    let eyes = counted.iter().filter(|(name, _)| name.starts_with(EYES));
    let hard = eyes.map(|(name, count)| (name, times(*count))).filter(|(_, times)| *times > MOST);
    hard.map(|(name, times)| format!("{name}: {times:.1} × a usual frame, at most {MOST} × is allowed")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(pairs: &[(&str, u64)]) -> BTreeMap<String, u64> {
        pairs.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect()
    }

    #[test]
    fn a_frame_that_takes_more_than_five_times_is_named() {
        let wrong = wrong(&counts(&[("component.eye", 999), ("eyes.noise", 51), ("eyes.flat", 50), (USUAL, 10)]));
        assert_eq!(wrong, ["eyes.noise: 5.1 × a usual frame, at most 5 × is allowed"]);
    }

    #[test]
    fn without_a_usual_frame_nothing_is_said_to_be_right() {
        assert_eq!(wrong(&counts(&[("eyes.noise", 1)])).len(), 1);
    }
}
