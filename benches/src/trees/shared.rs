//! Diamond: one child with two activators.

use bica::prelude::*;

macro_rules! component {
    ($name:ident $(, $child:ident: $kind:ident)*) => {
        #[doc = "Corner of the diamond."]
        pub struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self { Self(1) }

            fn step(&mut self $(, $child: &$kind)*) {
                self.0 = self.0.wrapping_mul(31).wrapping_add(1) $(.wrapping_add($child.0))*;
            }
        }
    };
}
component!(Shared);
component!(Left, shared: Shared);
component!(Right, shared: Shared);
component!(Root, left: Left, right: Right);

activation_tree! {
    /// Two components require the same child, which runs once in a cycle.
    pub struct Diamond { root: Root, cycle_hz: 1000, components: [Root, Left, Right, Shared] }
}
