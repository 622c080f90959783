//! Messages of the compiler, and trees at the limits.
//!
//! `table` has the mistakes that the text of one item shows; see `table.rs`. `fail` has those that need the compiler:
//! one file for mistakes that the compiler finds together, with all its messages, as a mistake must not bring further ones.
//!
//! `TRYBUILD=overwrite cargo test -p bica -- --include-ignored` replaces the expected messages; review them
//! before a commit.
//!
//! `valid` has unusual forms that compile.
//!
//! `limits` has one program for each limit. What is larger by one is refused; `messages.rs` of bica-core tests that.

mod table;
mod valid;

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("tests/ui/fail/*.rs");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_trees_at_the_limits_compile_and_run() {
    trybuild::TestCases::new().pass("tests/ui/limits/*.rs");
}
