//! Test tree, controlled by component indices.

use bica::prelude::*;

use super::unit::Unit;

/// Entry or exit hook; a `GRAPH` does not list them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hook {
    pub(crate) of: &'static str,
    pub(crate) state: &'static str,
    pub(crate) entry: bool,
    pub(crate) name: &'static str,
}

/// Tree of test components.
pub(crate) trait TestTree: Tree + Default {
    /// All hooks, in source order.
    const HOOKS: &'static [Hook];

    /// Outcomes that functions of transitions take: component, function and child.
    const OUTCOMES: &'static [[&'static str; 3]];

    fn unit(&mut self, index: usize) -> &mut Unit;
}

/// Implements [`TestTree`] for a tree: its components in the order of its list, its hooks, and the outcomes that conditions take.
macro_rules! test_tree {
    (
        $tree:ty: [$($component:ty),* $(,)?]
        $(, entry: [$($of:ident.$state:ident: $entry:ident),*])?
        $(, exit: [$($eof:ident.$estate:ident: $exit:ident),*])?
        $(, outcomes: [$($by:ident.$function:ident: $child:ident),*])?
    ) => {
        impl crate::semantics::test_tree::TestTree for $tree {
            const HOOKS: &'static [crate::semantics::test_tree::Hook] = &[
                $($(crate::semantics::test_tree::Hook {
                    of: stringify!($of), state: stringify!($state), entry: true, name: stringify!($entry),
                },)*)?
                $($(crate::semantics::test_tree::Hook {
                    of: stringify!($eof), state: stringify!($estate), entry: false, name: stringify!($exit),
                },)*)?
            ];

            const OUTCOMES: &'static [[&'static str; 3]] =
                &[$($([stringify!($by), stringify!($function), stringify!($child)],)*)?];

            fn unit(&mut self, index: usize) -> &mut crate::semantics::unit::Unit {
                $(if index == <$tree>::id::<$component>().index() {
                    return &mut self.get_mut::<$component>().unit;
                })*
                panic!("no component has index {index}")
            }
        }
    };
}
pub(crate) use test_tree;
