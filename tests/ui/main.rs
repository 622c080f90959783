//! The compiler's messages: one file in `fail` for each mistake, named after it, with the message that a user reads.
//!
//! `TRYBUILD=overwrite cargo test -p bica-ui-tests --test ui` writes the messages anew; read them before they are
//! committed.

#[test]
fn each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("fail/*.rs");
}
