//! Ten active components, alone and among ninety that are latent.
//!
//! The root is a machine that stays in a state with a chain of nine; in the larger tree another state has a chain of
//! ninety.

mod alone {
    use bica::prelude::*;
    nine!(links!(every:));

    /// The root.
    pub struct Root;

    #[component]
    impl Root {
        #[state(initial)]
        fn few(&mut self, _chain: &A1) {}

        #[state]
        fn none(&mut self) {}

        #[transition(few -> none)]
        fn to_none(&self) -> bool {
            std::hint::black_box(false)
        }

        #[transition(none -> few)]
        fn to_few(&self) -> bool {
            true
        }
    }

    macro_rules! tree {
        ($($name:ident)*) => {
            activation_tree! {
                /// Ten components, all active.
                pub struct TenOfTen {
                    root: Root,
                    cycle_hz: 1000,
                    components: [Root = Root, $($name),*],
                }
            }
        };
    }
    nine!(tree!());
}

mod among {
    use bica::prelude::*;
    nine!(links!(every:));
    ninety!(links!(every:));

    /// The root.
    pub struct Root;

    #[component]
    impl Root {
        #[state(initial)]
        fn few(&mut self, _chain: &A1) {}

        #[state]
        fn many(&mut self, _chain: &B0) {}

        #[transition(few -> many)]
        fn to_many(&self) -> bool {
            std::hint::black_box(false)
        }

        #[transition(many -> few)]
        fn to_few(&self) -> bool {
            true
        }
    }

    macro_rules! tree {
        ($($name:ident)*) => {
            activation_tree! {
                /// A hundred components, ten of them active.
                pub struct TenOfHundred {
                    root: Root,
                    cycle_hz: 1000,
                    components: [Root = Root, $($name),*],
                }
            }
        };
    }
    macro_rules! rest {
        ($($names:ident)*) => { ninety!(tree!($($names)*)); };
    }
    nine!(rest!());
}

pub use alone::TenOfTen;
pub use among::TenOfHundred;
