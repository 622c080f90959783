//! Unified diffs.

use similar::TextDiff;

/// The difference of two texts of a file, as `diff -u` prints it; empty if there is none.
#[must_use]
pub fn unified(name: &str, before: &str, after: &str) -> String {
    let diff = TextDiff::from_lines(before, after);
    diff.unified_diff().context_radius(3).header(&format!("a/{name}"), &format!("b/{name}")).to_string()
}
