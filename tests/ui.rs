//! The words of the compiler for every mistake that it finds: one file for each, named after the mistake.

#[test]
fn every_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("ui/*.rs");
}
