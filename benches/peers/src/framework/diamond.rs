//! Diamond: one component is required by two.

use bica::prelude::*;

use crate::framework::tree;
use crate::part::mix;

macro_rules! corner {
    ($name:ident, $step:item) => {
        #[doc = "Corner of the diamond."]
        pub struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self {
                Self(1)
            }

            $step
        }
    };
}

corner!(
    Bottom,
    fn step(&mut self) {
        self.0 = mix(0, [self.0]);
    }
);
corner!(
    Left,
    fn step(&mut self, bottom: &Bottom) {
        self.0 = mix(1, [bottom.0]);
    }
);
corner!(
    Right,
    fn step(&mut self, bottom: &Bottom) {
        self.0 = mix(2, [bottom.0]);
    }
);
corner!(
    Top,
    fn step(&mut self, left: &Left, right: &Right) {
        self.0 = mix(3, [left.0, right.0]);
    }
);

tree! {
    /// Four components; one of them is required by two.
    Diamond: Top Left Right Bottom
}
