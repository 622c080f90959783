//! Unified diffs.

use similar::TextDiff;

/// Returns the difference of two texts in the format of `diff -u`; empty if they are equal.
#[must_use]
pub fn unified(name: &str, before: &str, after: &str) -> String {
    let diff = TextDiff::from_lines(before, after);
    diff.unified_diff().context_radius(3).header(&format!("a/{name}"), &format!("b/{name}")).to_string()
}
