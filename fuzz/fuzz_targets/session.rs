//! The session language: any text is a script, whose jumps the parser itself checks, or has errors at places of the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use therapy::script::Script;

fuzz_target!(|text: &str| if let Err(problems) = Script::parse(text) {
    let lines = text.lines().count().max(1);
    assert!(!problems.is_empty() && problems.iter().all(|problem| (1..=lines + 1).contains(&problem.line)));
});
