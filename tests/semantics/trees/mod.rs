//! Test trees.

pub(crate) mod chain;
pub(crate) mod deep;
pub(crate) mod diamond;
pub(crate) mod fan;
pub(crate) mod generic;
pub(crate) mod modulated;
pub(crate) mod resume;
pub(crate) mod swap;
pub(crate) mod timers;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use crate::support::script::{Script, Stress, scripts};

/// Number of random scripts for each rule and tree: 100, or `BICA_TEST_CASES`, which is 1000 in CI.
pub(crate) fn cases() -> u32 {
    std::env::var("BICA_TEST_CASES").map_or(100, |cases| cases.parse().expect("BICA_TEST_CASES is a number"))
}

/// Checks a property of random scripts. One function for all rules and trees: each copy of the runner of proptest takes
/// time to compile.
///
/// # Panics
/// If the property does not hold; the message contains the smallest script that was found.
#[track_caller]
pub(crate) fn check(test: &'static str, stress: Stress, property: fn(&Script) -> Result<(), TestCaseError>) {
    let config =
        ProptestConfig { source_file: Some(file!()), test_name: Some(test), ..ProptestConfig::with_cases(cases()) };
    let mut runner = TestRunner::new(config);
    if let Err(error) = runner.run(&scripts(stress), |script| property(&script)) {
        panic!("{error}\n{runner}");
    }
}

/// Generates a test of a rule for each tree.
macro_rules! on_trees {
    ($rule:ident($stress:expr): $($name:ident $tree:ty),* $(,)?) => {
        $(
            #[test]
            fn $name() {
                crate::trees::check(concat!(module_path!(), "::", stringify!($name)), $stress, |script| {
                    $rule::<$tree>(&crate::support::play::play::<$tree>(script)?)
                });
            }
        )*
    };
    ($rule:ident($stress:expr)) => {
        crate::trees::on_trees!($rule($stress):
            chain crate::trees::chain::Chain,
            diamond crate::trees::diamond::Diamond,
            fan crate::trees::fan::Fan,
            deep crate::trees::deep::Deep,
            swap crate::trees::swap::Swap,
            timers crate::trees::timers::Timers,
            resume crate::trees::resume::Resume,
            generic crate::trees::generic::Generic,
            modulated crate::trees::modulated::Modulated,
        );
    };
}
pub(crate) use on_trees;
