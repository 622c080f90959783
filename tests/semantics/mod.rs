//! Semantics of activation trees: in random scripts, the events of trees that are written with the macros are compared
//! with those of a model.
//!
//! [`rules`] is the model. Scripts tick the tree, set flags that transitions read, change rates, hold components and
//! make machines go to states; components record their calls, times and values.

mod event;
mod graph;
mod jobs;
mod play;
mod rules;
mod script;
mod test_tree;
mod trees;
mod unit;
mod unwinding;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use event::counts;
use play::play;
use script::{Script, Stress, scripts};

/// Number of random scripts for each test: 200, or `BICA_TEST_CASES`, which is 1000 in CI.
fn cases() -> u32 {
    std::env::var("BICA_TEST_CASES").map_or(200, |cases| cases.parse().expect("BICA_TEST_CASES is a number"))
}

/// Compares a tree with its model in random scripts. It is not generic over the tree, because each copy of proptest's
/// runner takes time to compile.
///
/// # Panics
/// If they differ; the message contains the smallest script that was found.
#[track_caller]
fn check(test: &'static str, stress: Stress, play: fn(&Script) -> Result<(), TestCaseError>) {
    let config =
        ProptestConfig { source_file: Some(file!()), test_name: Some(test), ..ProptestConfig::with_cases(cases()) };
    let mut runner = TestRunner::new(config);
    if let Err(error) = runner.run(&scripts(stress), |script| play(&script)) {
        panic!("{error}\n{runner}");
    }
    let (calls, panicked) = counts();
    assert!(calls > 0 && (panicked > 0) == (stress.panics > 0), "{calls} calls, {panicked} of which panicked");
}

/// Generates a module with a test for each tree.
macro_rules! on_trees {
    ($(#[$doc:meta])* $module:ident, $stress:expr) => {
        on_trees!(
            $(#[$doc])* $module, $stress,
            carried: Carrying, diamond: Diamond, generic: Generic, modulated: Modulated, results: Results,
            resume: Resume, roles: Asking, swap: Swap, timers: Timers, works: Works,
            writers: Writers
        );
    };
    ($(#[$doc:meta])* $module:ident, $stress:expr, $($name:ident: $tree:ident),*) => {
        $(#[$doc])*
        mod $module {
            use super::*;

            $(
                #[test]
                fn $name() {
                    check(concat!(module_path!(), "::", stringify!($name)), $stress, play::<trees::$name::$tree>);
                }
            )*
        }
    };
}

on_trees!(
    /// Transitions at a steady clock, with a few changed rates.
    transitions,
    Stress { flags: 10, rates: 1, ways: 2, ..Stress::default() }
);

on_trees!(
    /// Rates that components set for their children, and that are set from outside.
    rates,
    Stress { flags: 4, rates: 4, ways: 1, ..Stress::default() }
);

on_trees!(
    /// Components held active and latent.
    holds,
    Stress { flags: 4, rates: 1, holds: 8, ways: 4, ..Stress::default() }
);

on_trees!(
    /// All of these, with a clock that jumps and goes back.
    jumps,
    Stress { flags: 6, rates: 6, holds: 4, ways: 4, jumps: true, ..Stress::default() }
);

on_trees!(
    /// Steps, states, conditions, hooks and jobs that panic.
    panics,
    Stress { flags: 8, rates: 1, holds: 3, ways: 2, panics: 20, ..Stress::default() }
);
