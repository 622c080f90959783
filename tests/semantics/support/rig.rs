//! A test tree from outside, by index.

use bica::prelude::*;

use super::unit::Unit;

/// An entry or exit hook; a `GRAPH` does not list them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hook {
    pub(crate) of: &'static str,
    pub(crate) state: &'static str,
    pub(crate) entry: bool,
    pub(crate) name: &'static str,
}

/// A tree whose components are test components.
pub(crate) trait Rig: Tree + Default {
    /// All hooks, in the order of the text.
    const HOOKS: &'static [Hook];

    fn unit(&mut self, index: usize) -> &mut Unit;
    fn set_rate(&mut self, index: usize, hz: f32);
    fn reset_rate(&mut self, index: usize);
}

/// Makes a tree a rig: its components in the order of its list, and its hooks.
macro_rules! rig {
    ($tree:ty: [$($component:ty),* $(,)?] $(, entry: [$($of:ident.$state:ident: $entry:ident),*])? $(, exit: [$($eof:ident.$estate:ident: $exit:ident),*])?) => {
        impl crate::support::rig::Rig for $tree {
            const HOOKS: &'static [crate::support::rig::Hook] = &[
                $($(crate::support::rig::Hook {
                    of: stringify!($of), state: stringify!($state), entry: true, name: stringify!($entry),
                },)*)?
                $($(crate::support::rig::Hook {
                    of: stringify!($eof), state: stringify!($estate), entry: false, name: stringify!($exit),
                },)*)?
            ];

            fn unit(&mut self, index: usize) -> &mut crate::support::unit::Unit {
                $(if index == <$tree>::id::<$component>().index() {
                    return &mut self.get_mut::<$component>().unit;
                })*
                panic!("no component {index}")
            }

            fn set_rate(&mut self, index: usize, hz: f32) {
                $(if index == <$tree>::id::<$component>().index() {
                    self.rate_mut::<$component>().set(hz);
                })*
            }

            fn reset_rate(&mut self, index: usize) {
                $(if index == <$tree>::id::<$component>().index() {
                    self.rate_mut::<$component>().reset();
                })*
            }
        }
    };
}
pub(crate) use rig;
