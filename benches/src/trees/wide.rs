//! Root with several chains: one chain of nine components, or nine more chains of ten.

mod one {
    use bica::prelude::*;
    nine!(links!(every:));

    /// Root of one chain.
    pub struct Root(u64);

    #[component]
    impl Root {
        const fn new() -> Self {
            Self(1)
        }

        fn step(&mut self, a: &A1) {
            self.0 = a.0;
        }
    }

    macro_rules! tree {
        ($($name:ident)*) => {
            activation_tree! {
                /// Ten components.
                pub struct WideTen { root: Root, cycle_hz: 1000, components: [Root, $($name),*] }
            }
        };
    }
    nine!(tree!());
}

mod ten {
    use bica::prelude::*;
    nine!(links!(every:));
    links!(every: B0 B1 B2 B3 B4 B5 B6 B7 B8 B9);
    links!(every: C0 C1 C2 C3 C4 C5 C6 C7 C8 C9);
    links!(every: D0 D1 D2 D3 D4 D5 D6 D7 D8 D9);
    links!(every: E0 E1 E2 E3 E4 E5 E6 E7 E8 E9);
    links!(every: F0 F1 F2 F3 F4 F5 F6 F7 F8 F9);
    links!(every: G0 G1 G2 G3 G4 G5 G6 G7 G8 G9);
    links!(every: H0 H1 H2 H3 H4 H5 H6 H7 H8 H9);
    links!(every: I0 I1 I2 I3 I4 I5 I6 I7 I8 I9);
    links!(every: J0 J1 J2 J3 J4 J5 J6 J7 J8 J9);

    /// Root of ten chains.
    pub struct Root(u64);

    #[component]
    impl Root {
        const fn new() -> Self {
            Self(1)
        }

        fn step(&mut self, a: &A1, b: &B0, c: &C0, d: &D0, e: &E0, f: &F0, g: &G0, h: &H0, i: &I0, j: &J0) {
            self.0 = a.0 ^ b.0 ^ c.0 ^ d.0 ^ e.0 ^ f.0 ^ g.0 ^ h.0 ^ i.0 ^ j.0;
        }
    }

    macro_rules! tree {
        ($($name:ident)*) => {
            activation_tree! {
                /// Hundred components.
                pub struct WideHundred { root: Root, cycle_hz: 1000, components: [Root, $($name),*] }
            }
        };
    }
    macro_rules! rest {
        ($($names:ident)*) => { ninety!(tree!($($names)*)); };
    }
    nine!(rest!());
}

pub use one::WideTen;
pub use ten::WideHundred;
