//! The compiler's messages: one file in `fail` for each mistake, named after it, with the message that a user reads.

#[test]
fn each_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("fail/*.rs");
}
