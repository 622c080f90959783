//! Ten active components, alone and with ninety latent ones.
//!
//! The root is a state machine that stays in its first state, which has a chain of nine components. In the larger tree the
//! second state has a chain of ninety.

/// Root with an active chain, and a latent chain if one is named.
macro_rules! root {
    ($($latent:ident)?) => {
        /// State machine that stays in its first state.
        pub struct Root;

        #[component]
        impl Root {
            #[state(initial)]
            fn first(&mut self, _chain: &A1) {}

            #[state]
            fn second(&mut self $(, _chain: &$latent)?) {}

            #[transition(first -> second)]
            fn to_second(&self) -> bool {
                std::hint::black_box(false)
            }

            #[transition(second -> first)]
            fn to_first(&self) -> bool {
                true
            }
        }
    };
}

macro_rules! tree {
    ($doc:literal $tree:ident $($name:ident)*) => {
        activation_tree! {
            #[doc = $doc]
            pub struct $tree {
                root: Root,
                cycle_hz: 1000,
                components: [Root = Root, $($name),*],
            }
        }
    };
}

mod ten {
    use bica::prelude::*;
    nine!(links!(every:));
    root!();
    nine!(tree!("Ten components, all active." TenOfTen));
}

mod hundred {
    use bica::prelude::*;
    nine!(links!(every:));
    ninety!(links!(every:));
    root!(B0);

    macro_rules! rest {
        ($($names:ident)*) => { ninety!(tree!("Hundred components, ten of them active." TenOfHundred $($names)*)); };
    }
    nine!(rest!());
}

pub use hundred::TenOfHundred;
pub use ten::TenOfTen;
