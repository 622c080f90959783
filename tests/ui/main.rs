//! Messages of the compiler, and trees at the limits.
//!
//! `fail` has one file for each mistake, named after it, with the expected message.
//! `TRYBUILD=overwrite cargo test -p bica-ui-tests -- --ignored` replaces the expected messages; review them before a commit.
//!
//! `limits` has one program for each limit. What is larger by one is refused, see `fail/limit_*.rs`.

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("fail/*.rs");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_trees_at_the_limits_compile_and_run() {
    trybuild::TestCases::new().pass("limits/*.rs");
}
