//! The session language: any text is a script whose steps lead to steps, or has errors at places of the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use therapy::script::Script;
use therapy::session::Step;

fuzz_target!(|text: &str| match Script::parse(text) {
    Ok(script) => {
        let most = script.steps.len();
        for step in &script.steps {
            match *step {
                Step::GoTo(to) | Step::Again { from: to, .. } => assert!(usize::from(to) <= most),
                Step::Exercise { then, .. } => assert!(then.into_iter().all(|to| usize::from(to) <= most)),
                _ => {}
            }
        }
    }
    Err(problems) => {
        let lines = text.lines().count().max(1);
        assert!(!problems.is_empty() && problems.iter().all(|problem| (1..=lines + 1).contains(&problem.line)));
    }
});
