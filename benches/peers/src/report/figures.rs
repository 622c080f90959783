//! What was measured.

use std::collections::BTreeMap;
use std::str::FromStr;

/// Makes an enum whose values have names, for a table and for the pipe between two processes.
macro_rules! named {
    ($(#[$doc:meta])* $name:ident { $($(#[$each:meta])* $value:ident = $text:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$each])* $value,)*
        }

        impl $name {
            /// All, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$value),*];

            /// What the table calls it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$value => $text,)*
                }
            }
        }

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                let found = Self::ALL.iter().find(|value| value.name() == text);
                found.copied().ok_or_else(|| format!("`{text}` is none of {:?}", Self::ALL))
            }
        }
    };
}

named! {
    /// A way to do the work.
    Way {
        /// With the framework.
        Bica = "BICA",
        /// With the framework, each component's time taken by a `Stopwatch`.
        BicaTimed = "BICA, timed",
        /// With copper-rs.
        Copper = "copper-rs (always timed)",
        /// With copper-rs and a clock that a test would move by hand.
        CopperMocked = "copper-rs, clock mocked",
        /// As functions, or a `match`.
        ByHand = "by hand",
        /// The same with two timestamps for each component.
        ByHandTimed = "by hand, timed",
        /// As `Box<dyn Component>`.
        Boxed = "Box<dyn Component>",
        /// The same with two timestamps for each component.
        BoxedTimed = "Box<dyn Component>, timed",
        /// A blackboard with call-backs.
        Callbacks = "blackboard, call-backs",
        /// A blackboard with channels.
        Channels = "blackboard, channels",
        /// With statig.
        Statig = "statig",
        /// With smlang.
        Smlang = "smlang",
    }
}

named! {
    /// Some work.
    Work {
        /// A chain of three.
        Chain3 = "chain of 3",
        /// A chain of ten.
        Chain10 = "chain of 10",
        /// A chain of a hundred.
        Chain100 = "chain of 100",
        /// The diamond.
        Diamond = "diamond",
        /// The machine of five states.
        Machine = "machine of 5",
        /// The tree of the forward.
        Forward = "tree of 25",
        /// Ten components: one that needs nine.
        Tree10 = "10 in a tree",
        /// A hundred components: one that needs eleven, each of which needs eight.
        Tree100 = "100 in a tree",
        /// Ten components, all active.
        Active = "10 of 10 active",
        /// A hundred components, ten of them active.
        Latent = "10 of 100 active",
    }
}

/// The figures of a run.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    /// Least time of a cycle, ns.
    pub times: BTreeMap<(Way, Work), f64>,
    /// Heap allocations in a cycle.
    pub heap: BTreeMap<(Way, Work), f64>,
    /// What a program with the work is larger than an empty one, bytes.
    pub sizes: BTreeMap<(Way, Work), u64>,
}

impl Figures {
    /// Notes a time; the least counts.
    pub fn note(&mut self, way: Way, work: Work, ns: f64) {
        let least = self.times.entry((way, work)).or_insert(ns);
        *least = least.min(ns);
    }

    /// How many times as long the first takes as the second; `None` if either was not measured.
    #[must_use]
    pub fn ratio(&self, more: (Way, Work), less: (Way, Work)) -> Option<f64> {
        Some(self.times.get(&more)? / self.times.get(&less)?)
    }
}
