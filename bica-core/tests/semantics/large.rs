//! Tree with more components than a machine word has bits.

use super::*;

pub(crate) struct Leaf<const N: usize> {
    runs: u32,
}

#[component(crate = bica_core)]
impl<const N: usize> Leaf<N> {
    const fn new() -> Self {
        Self { runs: 0 }
    }

    fn step(&mut self) {
        self.runs += 1;
    }
}

/// Generates a branch for each ten leaves, and a tree of all.
macro_rules! branches {
    ($($branch:ident: $($leaf:literal)*;)*) => {
        $(
            pub(crate) struct $branch;

            #[component(crate = bica_core)]
            impl $branch {
                const fn new() -> Self {
                    Self
                }

                fn step(&mut self $(, _: &Leaf<$leaf>)*) {}
            }
        )*

        pub(crate) struct Trunk;

        #[component(crate = bica_core)]
        impl Trunk {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self $(, _: &$branch)*) {}
        }

        activation_tree! {
            pub(crate) struct Large {
                root: Trunk,
                cycle_hz: 10,
                components: [$($(Leaf<$leaf>,)* $branch,)* Trunk],
                crate: bica_core,
            }
        }
    };
}

branches! {
    A: 0 1 2 3 4 5 6 7 8 9;
    B: 10 11 12 13 14 15 16 17 18 19;
    C: 20 21 22 23 24 25 26 27 28 29;
    D: 30 31 32 33 34 35 36 37 38 39;
    E: 40 41 42 43 44 45 46 47 48 49;
    F: 50 51 52 53 54 55 56 57 58 59;
    G: 60 61 62 63 64 65 66 67 68 69;
}

#[test]
fn every_component_is_visited_and_stopped() {
    let mut tree = Large::new();
    assert_eq!(runs(&mut tree, 0).len(), 78);
    assert_eq!(tree.active().count(), 78);
    tree.hold::<G>(Hold::Latent);
    let stops = cycle(&mut tree, 100).iter().filter(|line| line.starts_with("stop")).count();
    assert_eq!((stops, tree.active().count()), (11, 67));
    assert_eq!((tree.get::<Leaf<59>>().runs, tree.get::<Leaf<69>>().runs), (2, 1));
}

#[test]
fn any_component_can_be_held() {
    let mut tree = Large::new();
    tree.hold::<Trunk>(Hold::Latent);
    for index in 0..Large::COUNT {
        tree.hold_at(index, Hold::Active).unwrap();
        tree.tick(at(0));
        assert!(tree.is_active_at(index), "{index}");
        tree.hold_at(index, Hold::Tree).unwrap();
        tree.hold::<Trunk>(Hold::Latent);
    }
}
