//! Measured figures.

use std::collections::BTreeMap;
use std::str::FromStr;

/// Generates an enum whose values have names, for tables and for the pipe between two processes.
macro_rules! named {
    ($(#[$doc:meta])* $name:ident { $($(#[$each:meta])* $value:ident = $text:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$each])* $value,)*
        }

        impl $name {
            /// All values, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$value),*];

            /// Name in tables.
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
                found.copied().ok_or_else(|| format!("`{text}` is not one of {:?}", Self::ALL))
            }
        }
    };
}

named! {
    /// Implementation of a workload.
    Design {
        /// Activation tree of BICA.
        Bica = "BICA",
        /// BICA with a `Stopwatch` that measures each component.
        BicaTimed = "BICA, timed",
        /// copper-rs.
        Copper = "copper-rs (always timed)",
        /// copper-rs with its mock clock for tests.
        CopperMocked = "copper-rs, clock mocked",
        /// Functions or a `match`, written by hand.
        ByHand = "by hand",
        /// Functions written by hand, all inlined.
        ByHandInlined = "by hand, inlined",
        /// Written by hand, with two timestamps for each component.
        ByHandTimed = "by hand, timed",
        /// `Box<dyn Component>` in a list.
        Boxed = "Box<dyn Component>",
        /// The list with two timestamps for each component.
        BoxedTimed = "Box<dyn Component>, timed",
        /// Blackboard with callbacks.
        Callbacks = "blackboard, callbacks",
        /// Blackboard with channels.
        Channels = "blackboard, channels",
        /// statig.
        Statig = "statig",
        /// smlang.
        Smlang = "smlang",
    }
}

named! {
    /// Workload.
    Workload {
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
        /// The chain of ten with steps of realistic size.
        SizedChain10 = "chain of 10, 20 ns",
        /// The machine with steps of realistic size.
        SizedMachine = "machine of 5, 20 ns",
        /// The tree of the forward with steps of realistic size.
        SizedForward = "tree of 25, 20 ns",
        /// Ten components: one requires nine.
        Tree10 = "10 in a tree",
        /// Hundred components: one requires eleven, each of which requires eight.
        Tree100 = "100 in a tree",
        /// Ten components, all active.
        Active = "10 of 10 active",
        /// A hundred components, ten of them active.
        Latent = "10 of 100 active",
    }
}

impl Workload {
    /// Rounds of work in each step: 24 take about 20 ns.
    #[must_use]
    pub const fn rounds(self) -> u32 {
        match self {
            Self::Chain3 | Self::Chain10 | Self::Chain100 | Self::Diamond | Self::Machine | Self::Forward => 0,
            _ => 24,
        }
    }
}

/// Figures of a run.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    /// Minimum time of a cycle, ns.
    pub times: BTreeMap<(Design, Workload), f64>,
    /// Heap allocations per cycle.
    pub heap: BTreeMap<(Design, Workload), f64>,
    /// Size of a program with the workload minus that of an empty one, bytes.
    pub sizes: BTreeMap<(Design, Workload), u64>,
}

impl Figures {
    /// Records a time; the minimum is kept.
    pub fn record(&mut self, design: Design, workload: Workload, ns: f64) {
        let minimum = self.times.entry((design, workload)).or_insert(ns);
        *minimum = minimum.min(ns);
    }

    /// Ratio of the times of two cases; `None` if one was not measured.
    #[must_use]
    pub fn ratio(&self, more: (Design, Workload), less: (Design, Workload)) -> Option<f64> {
        Some(self.times.get(&more)? / self.times.get(&less)?)
    }
}
