//! Macros that generate many components.

/// Components of a chain: each requires the next.
macro_rules! links {
    ($rate:tt: $name:ident $next:ident $($rest:ident)*) => {
        links!(@component $rate $name, fn step(&mut self, next: &$next) { self.0 = next.0.wrapping_mul(31).wrapping_add(1); });
        links!($rate: $next $($rest)*);
    };
    ($rate:tt: $last:ident) => {
        links!(@component $rate $last, fn step(&mut self) { self.0 = self.0.wrapping_mul(31).wrapping_add(1); });
    };
    (@component every $name:ident, $step:item) => {
        #[doc = "A link of the chain."]
        pub struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self { Self(1) }
            $step
        }
    };
    (@component rarely $name:ident, $step:item) => {
        #[doc = "A link of the chain."]
        pub struct $name(u64);

        #[component(hz = 0.001)]
        impl $name {
            const fn new() -> Self { Self(1) }
            $step
        }
    };
}

/// Tree that consists of a chain only.
macro_rules! chain {
    ($tree:ident, $rate:tt: $first:ident $($rest:ident)*) => {
        links!($rate: $first $($rest)*);
        activation_tree! {
            /// A chain.
            pub struct $tree { root: $first, cycle_hz: 1000, components: [$first, $($rest),*] }
        }
    };
}

/// Passes the names of nine components to a macro; `ninety!` passes ninety other names.
macro_rules! nine {
    ($then:ident!($($before:tt)*) $($after:tt)*) => {
        $then! { $($before)* A1 A2 A3 A4 A5 A6 A7 A8 A9 $($after)* }
    };
}
macro_rules! ninety {
    ($then:ident!($($before:tt)*) $($after:tt)*) => {
        $then! {
            $($before)*
            B0 B1 B2 B3 B4 B5 B6 B7 B8 B9 C0 C1 C2 C3 C4 C5 C6 C7 C8 C9 D0 D1 D2 D3 D4 D5 D6 D7 D8 D9
            E0 E1 E2 E3 E4 E5 E6 E7 E8 E9 F0 F1 F2 F3 F4 F5 F6 F7 F8 F9 G0 G1 G2 G3 G4 G5 G6 G7 G8 G9
            H0 H1 H2 H3 H4 H5 H6 H7 H8 H9 I0 I1 I2 I3 I4 I5 I6 I7 I8 I9 J0 J1 J2 J3 J4 J5 J6 J7 J8 J9
            $($after)*
        }
    };
}
