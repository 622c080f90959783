//! With the framework.

mod chain;
mod diamond;
mod forward;
mod latent;
mod machine;
mod wide;

use bica::{Instant, Probe, Tree};

use crate::subject::Subject;

pub use chain::{Chain3, Chain10, Chain100};
pub use diamond::Diamond;
pub use forward::Forward;
pub use latent::{Active, Latent};
pub use machine::Machine;
pub use wide::{Tree10, Tree100};

/// A tree that does some of the work.
pub trait Answer: Tree {
    /// A new one, at rest.
    fn at_rest() -> Self;

    /// What the work came to.
    fn answer(&self) -> u64;

    /// What comes from outside before a cycle.
    fn sense(&mut self, _now: u64) {}
}

/// A tree, watched by a probe: `()` is none.
pub struct Ours<T, P> {
    tree: T,
    probe: P,
}

impl<T: Answer, P: Probe> Ours<T, P> {
    /// At rest.
    pub fn new(probe: P) -> Self {
        Self { tree: T::at_rest(), probe }
    }
}

impl<T: Answer, P: Probe> Subject for Ours<T, P> {
    fn cycle(&mut self, now: u64) {
        self.tree.sense(now);
        self.tree.tick_with(Instant::from_micros(now), &mut self.probe);
    }

    fn result(&self) -> u64 {
        self.tree.answer()
    }
}

/// A tree of the first component, whose number is the answer.
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

        impl crate::ours::Answer for $tree {
            fn at_rest() -> Self {
                Self::new()
            }

            fn answer(&self) -> u64 {
                self.get::<$root>().0
            }
        }
    };
}
/// One component for each name, each of which requires the next.
macro_rules! links {
    ($name:ident $next:ident $($rest:ident)*) => {
        links!(@ $name, fn step(&mut self, next: &$next) { self.0 = mix(0, [next.0]); });
        links!($next $($rest)*);
    };
    ($name:ident) => {
        links!(@ $name, fn step(&mut self) { self.0 = mix(0, [self.0]); });
    };
    (@ $name:ident, $step:item) => {
        #[doc = "A link of a chain."]
        pub struct $name(u64);

        #[component]
        impl $name {
            const fn new() -> Self { Self(1) }
            $step
        }
    };
}

use {links, tree};
