//! Upper bound on the cost of the slowest frame, relative to a typical one.

use std::collections::BTreeMap;

/// Prefix of the benchmarks of single frames: typical rendered frames and synthetic worst-case frames.
pub(super) const VISION: &str = "vision.";
pub(super) const USUAL: &str = "vision.usual";
/// Largest accepted ratio of a frame's instructions to those of a typical frame.
const MAX_RATIO: f64 = 5.0;

/// Returns a message for each frame that takes too many instructions.
pub(crate) fn wrong(counted: &BTreeMap<String, u64>) -> Vec<String> {
    let Some(usual) = counted.get(USUAL) else { return vec![format!("{USUAL}: not counted")] };
    let times = |count: u64| count as f64 / *usual as f64;
    let frames = counted.iter().filter(|(name, _)| name.starts_with(VISION));
    let hard = frames.map(|(name, count)| (name, times(*count))).filter(|(_, times)| *times > MAX_RATIO);
    hard.map(|(name, times)| format!("{name}: {times:.1} × a typical frame, at most {MAX_RATIO} × is allowed"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(pairs: &[(&str, u64)]) -> BTreeMap<String, u64> {
        pairs.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect()
    }

    #[test]
    fn a_frame_above_five_times_the_typical_one_is_reported() {
        let wrong = wrong(&counts(&[("component.eye", 999), ("vision.noise", 51), ("vision.flat", 50), (USUAL, 10)]));
        assert_eq!(wrong, ["vision.noise: 5.1 × a typical frame, at most 5 × is allowed"]);
    }

    #[test]
    fn a_missing_typical_frame_is_reported() {
        assert_eq!(wrong(&counts(&[("vision.noise", 1)])).len(), 1);
    }
}
