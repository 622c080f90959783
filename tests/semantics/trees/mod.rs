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

/// Generates a test of a rule for each tree.
macro_rules! on_trees {
    ($rule:ident($stress:expr): $($name:ident $tree:ty),* $(,)?) => {
        proptest::proptest! {
            #![proptest_config(proptest::prelude::ProptestConfig::with_cases(1000))]
            $(
                #[test]
                fn $name(script in crate::support::script::scripts($stress)) {
                    let cycles = crate::support::play::play::<$tree>(&script)?;
                    $rule::<$tree>(&cycles)?;
                }
            )*
        }
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
