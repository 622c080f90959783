//! The drawing of the activation tree.

use crate::process::run;

#[test]
fn drawing_in_the_documentation_is_current() {
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/forward.svg");
    let kept = std::fs::read_to_string(kept).unwrap_or_default();
    let remedy = "draw it anew: cargo run --release -- graph --format svg > docs/forward.svg";
    assert!(
        kept == run(&["graph", "--format", "svg"]).stdout,
        "docs/forward.svg does not show the current tree; {remedy}"
    );
}
