//! Messages of the compiler: one file in `fail` for each mistake, named after it, with the expected message.
//!
//! `TRYBUILD=overwrite cargo test -p bica-ui-tests -- --ignored` replaces the expected messages; review them before a commit.

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("fail/*.rs");
}
