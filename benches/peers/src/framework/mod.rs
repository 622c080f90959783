//! Trees of BICA.

mod behavior_tree;
mod chain;
mod diamond;
mod forward;
mod latent;
mod machine;
mod wide;

use bica::{Instant, Probe, Tree};

use crate::subject::Subject;

pub use behavior_tree::{Fallback, Sequence};
pub use chain::{Chain3, Chain10, Chain100};
pub use diamond::Diamond;
pub use forward::Forward;
pub use latent::{Active, Latent};
pub use machine::Machine;
pub use wide::{Tree10, Tree100};

/// Tree that computes a workload.
pub trait WorkloadTree: Tree {
    /// Creates the tree.
    fn create() -> Self;

    /// Result of the workload.
    fn result(&self) -> u64;

    /// Writes the external input before a cycle.
    fn set_input(&mut self, _now: u64) {}
}

/// Tree with a probe; `()` is no probe.
pub struct BicaSubject<T, P> {
    tree: T,
    probe: P,
}

impl<T: WorkloadTree, P: Probe> BicaSubject<T, P> {
    /// Creates the tree.
    pub fn new(probe: P) -> Self {
        Self { tree: T::create(), probe }
    }
}

impl<T: WorkloadTree, P: Probe> Subject for BicaSubject<T, P> {
    fn cycle(&mut self, now: u64) {
        self.tree.set_input(now);
        self.tree.tick_with(Instant::from_micros(now), &mut self.probe);
    }

    fn result(&self) -> u64 {
        self.tree.result()
    }
}

/// Tree whose root is the first component; the root's number is the result.
macro_rules! tree {
    ($(#[$doc:meta])* $tree:ident: $root:ident $($rest:ident)*) => {
        activation_tree! {
            $(#[$doc])*
            pub struct $tree {
                root: $root,
                cycle_hz: 100,
                components: [$root $(, $rest)*],
            }
        }

        impl crate::framework::WorkloadTree for $tree {
            fn create() -> Self {
                Self::new()
            }

            fn result(&self) -> u64 {
                self.get::<$root>().own
            }
        }
    };
}

/// Component whose number is its only field, `own`.
macro_rules! simple {
    ($name:ident, $step:item) => {
        #[doc = "Component of a workload."]
        pub struct $name {
            own: u64,
        }

        #[component]
        impl $name {
            const fn new() -> Self {
                Self { own: 1 }
            }

            $step
        }
    };
}

/// Components of a chain: each requires the next.
macro_rules! links {
    ($name:ident $next:ident $($rest:ident)*) => {
        simple!($name, fn step(&mut self, next: &$next) { self.own = mix(0, [next.own]); });
        links!($next $($rest)*);
    };
    ($name:ident) => {
        leaves!($name);
    };
}

/// Components that require nothing.
macro_rules! leaves {
    ($($name:ident)*) => {
        $(simple!($name, fn step(&mut self) { self.own = mix(0, [self.own]); });)*
    };
}

use {leaves, links, simple, tree};
