//! The same workloads with copper-rs: one application for each graph, described in `config/`.
//!
//! The set-up follows its documents and benchmarks: release build, default features, a graph in RON,
//! `run_one_iteration` on the started application. The log of messages and task states is off, which is its fastest
//! setting.

mod task;

use cu29::prelude::{CuResult, RobotClock};

use crate::case::Case;
use crate::part::combine;
use crate::subject::Subject;

/// All cases, with Copper's clock and with its mock clock for tests.
///
/// # Errors
/// If Copper rejects an application.
pub fn cases() -> Result<Vec<Case>, String> {
    let clocks = [("copper-rs (always timed)", RobotClock::new()), ("copper-rs, clock mocked", RobotClock::mock().0)];
    let cases = clocks.into_iter().map(|(design, clock)| {
        Ok([
            Case::new::<false>(design, "chain of 3", chain_3(clock.clone())?),
            Case::new::<false>(design, "chain of 10", chain_10(clock.clone())?),
            Case::new::<false>(design, "chain of 100", chain_100(clock.clone())?),
            Case::new::<false>(design, "diamond", diamond(clock.clone())?),
            Case::new::<false>(design, "tree of 25", forward(clock)?),
        ])
    });
    let cases = cases.collect::<CuResult<Vec<_>>>().map_err(|error| format!("copper-rs failed to start: {error}"))?;
    Ok(cases.into_iter().flatten().collect())
}

/// Started application as a benchmark subject.
macro_rules! application {
    ($(#[$doc:meta])* $name:ident, $config:literal, $outputs:literal) => {
        mod $name {
            use cu29::prelude::*;

            #[copper_runtime(config = $config)]
            struct Application {}

            type Started = CuAppLifecycle<NoopSectionStorage, NoopLogger, Application, Running>;

            pub(super) struct Copper(Started);

            impl Copper {
                pub(super) fn start(clock: RobotClock) -> CuResult<Self> {
                    Ok(Self(Application::builder().with_clock(clock).build()?.start()?))
                }
            }

            impl super::Subject for Copper {
                fn cycle(&mut self, _now: u64) {
                    if let Err(error) = self.0.run_one_iteration() {
                        panic!("no task here returns an error, but Copper reports: {error}");
                    }
                }

                fn result(&self) -> u64 {
                    super::result::<$outputs>()
                }
            }
        }

        $(#[$doc])*
        /// The result is valid only directly after a cycle, because all applications write theirs to the same place.
        ///
        /// # Errors
        /// If Copper rejects the application.
        pub fn $name(clock: RobotClock) -> CuResult<impl Subject> {
            $name::Copper::start(clock)
        }
    };
}

application! {
    /// A chain of three.
    chain_3, "config/chain_3.ron", 1
}
application! {
    /// A chain of ten.
    chain_10, "config/chain_10.ron", 1
}
application! {
    /// A chain of a hundred.
    chain_100, "config/chain_100.ron", 1
}
application! {
    /// The diamond.
    diamond, "config/diamond.ron", 1
}
application! {
    /// The tree of the forward.
    forward, "config/forward.ron", 4
}

/// Result of one output, or a mixture of several.
fn result<const N: usize>() -> u64 {
    let outputs = task::results::<N>();
    if let [one] = outputs[..] { one } else { combine(0, outputs) }
}
