//! Trees of ten and of a hundred components, wide rather than deep.

/// Components, and the requirements of each.
macro_rules! branches {
    ($($name:ident: $($need:ident)*;)*) => {
        $(simple!($name, fn step(&mut self $(, $need: &$need)*) { self.own = mix(0, [$($need.own),*]); });)*
    };
}

#[expect(non_snake_case, reason = "an argument has the name of its type")]
mod ten {
    use bica::prelude::*;

    use crate::framework::{leaves, simple, tree};
    use crate::part::mix;

    leaves!(A B C D E F G H I);
    branches!(Root: A B C D E F G H I;);
    tree! {
        /// Ten components: one requires nine.
        Tree10: Root A B C D E F G H I
    }
}

/// A tree whose root requires components, each of which requires the rest of its group.
macro_rules! groups {
    ($(#[$doc:meta])* $tree:ident: $($name:ident: $($leaf:ident)*;)*) => {
        $(leaves!($($leaf)*);)*
        branches!(Root: $($name)*; $($name: $($leaf)*;)*);
        tree! { $(#[$doc])* $tree: Root $($name $($leaf)*)* }
    };
}

#[expect(non_snake_case, reason = "an argument has the name of its type")]
mod hundred {
    use bica::prelude::*;

    use crate::framework::{leaves, simple, tree};
    use crate::part::mix;

    groups! {
        /// Hundred components: one requires eleven, each of which requires eight.
        Tree100:
        A: A1 A2 A3 A4 A5 A6 A7 A8;
        B: B1 B2 B3 B4 B5 B6 B7 B8;
        C: C1 C2 C3 C4 C5 C6 C7 C8;
        D: D1 D2 D3 D4 D5 D6 D7 D8;
        E: E1 E2 E3 E4 E5 E6 E7 E8;
        F: F1 F2 F3 F4 F5 F6 F7 F8;
        G: G1 G2 G3 G4 G5 G6 G7 G8;
        H: H1 H2 H3 H4 H5 H6 H7 H8;
        I: I1 I2 I3 I4 I5 I6 I7 I8;
        J: J1 J2 J3 J4 J5 J6 J7 J8;
        K: K1 K2 K3 K4 K5 K6 K7 K8;
    }
}

pub use hundred::Tree100;
pub use ten::Tree10;
