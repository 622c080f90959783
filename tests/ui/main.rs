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
//! `limits` writes one program for each limit.

mod limits;
mod table;
mod valid;

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("tests/ui/fail/*.rs");
}
