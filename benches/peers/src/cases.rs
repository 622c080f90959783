//! All combinations of a design and a workload that are measured.

use std::hint::black_box;

use bica::{Probe, Stopwatch};

use crate::behavior_tree::{self, Bonsai};
use crate::boxed::Boxed;
use crate::callbacks::Callbacks;
use crate::case::Case;
use crate::channels::Channels;
use crate::framework::{self, BicaSubject, WorkloadTree};
use crate::machine::{ByHand, Smlang, Statig};
use crate::part::{DIAMOND, FORWARD, Part, chain};
use crate::plain;
use crate::subject::Subject;
use crate::timer::{Pairs, counter};

/// Probe that takes time at the end of every cycle, quadratic in the number `N` of components and longer than a step. It shows
/// that each check of a claim can fail.
struct SlowProbe<const N: usize>;

impl<const N: usize> Probe for SlowProbe<N> {
    fn cycle_end(&mut self) {
        for iteration in 0..N * N * 4 + 400 {
            black_box(iteration);
        }
    }
}

struct Cases {
    slow: bool,
    all: Vec<Case>,
}

impl Cases {
    fn add<const SIZED: bool>(
        &mut self,
        design: &'static str,
        workload: &'static str,
        subject: impl Subject + 'static,
    ) {
        self.all.push(Case::new::<SIZED>(design, workload, subject));
    }

    /// Adds a tree of `N` components: without a probe, and with a stopwatch that reads the counter that Copper reads. If the
    /// cases are slow, each also has a probe that takes time.
    fn bica<T: WorkloadTree + 'static, const N: usize, const SIZED: bool>(&mut self, workload: &'static str) {
        let watch = || Stopwatch::<_, N>::new(counter as fn() -> u64);
        let (design, timed) = ("BICA", "BICA, timed");
        if self.slow {
            self.add::<SIZED>(design, workload, BicaSubject::<T, _>::new(SlowProbe::<N>));
            self.add::<SIZED>(timed, workload, BicaSubject::<T, _>::new((watch(), SlowProbe::<N>)));
        } else {
            self.add::<SIZED>(design, workload, BicaSubject::<T, _>::new(()));
            self.add::<SIZED>(timed, workload, BicaSubject::<T, _>::new(watch()));
        }
    }

    /// Adds the late-bound designs of a graph.
    fn late(&mut self, workload: &'static str, parts: &[Part]) {
        self.add::<false>("Box<dyn Component>", workload, Boxed::new(parts, ()));
        self.add::<false>("Box<dyn Component>, timed", workload, Boxed::new(parts, pairs::<100>()));
        self.add::<false>("blackboard, callbacks", workload, Callbacks::new(parts));
        self.add::<false>("blackboard, channels", workload, Channels::new(parts));
    }
}

/// Timer that reads the counter before and after each component.
fn pairs<const N: usize>() -> Pairs<fn() -> u64, N> {
    Pairs::new(counter)
}

/// Adds the cases of a graph with empty steps; with `sized` those with steps of realistic size.
macro_rules! graph {
    ($cases:ident, $workload:literal: $tree:ident of $count:literal, $hand:ident $(<$size:literal>)?, $parts:expr) => {
        $cases.bica::<framework::$tree, $count, false>($workload);
        $cases.add::<false>("by hand", $workload, plain::$hand::<_, $($size,)? false>::new(()));
        $cases.add::<false>("by hand, timed", $workload, plain::$hand::<_, $($size,)? false>::new(pairs::<$count>()));
        $cases.add::<false>("by hand, inlined", $workload, plain::$hand::<_, $($size,)? true>::new(()));
        $cases.late($workload, $parts);
    };
    (sized $cases:ident, $workload:literal: $tree:ident of $count:literal, $hand:ident $(<$size:literal>)?, $parts:expr) => {
        $cases.bica::<framework::$tree, $count, true>($workload);
        $cases.add::<true>("by hand", $workload, plain::$hand::<_, $($size,)? false>::new(()));
        $cases.add::<true>("by hand, inlined", $workload, plain::$hand::<_, $($size,)? true>::new(()));
        $cases.add::<true>("Box<dyn Component>", $workload, Boxed::new($parts, ()));
    };
}

/// Creates all cases; with `slow`, those of BICA contain an artificial slowdown.
///
/// # Errors
/// If Copper rejects an application.
pub fn all(slow: bool) -> Result<Vec<Case>, String> {
    let mut cases = Cases { slow, all: Vec::new() };
    graph!(cases, "chain of 3": Chain3 of 3, Chain<3>, &chain::<3>());
    graph!(cases, "chain of 10": Chain10 of 10, Chain<10>, &chain::<10>());
    graph!(cases, "chain of 100": Chain100 of 100, Chain<100>, &chain::<100>());
    graph!(cases, "diamond": Diamond of 4, Diamond, &DIAMOND);
    graph!(cases, "tree of 25": Forward of 25, Forward, &FORWARD);
    graph!(sized cases, "chain of 10, 20 ns": Chain10 of 10, Chain<10>, &chain::<10>());
    graph!(sized cases, "tree of 25, 20 ns": Forward of 25, Forward, &FORWARD);
    machines(&mut cases);
    leaves(&mut cases);
    cases.bica::<framework::Tree10, 10, true>("10 in a tree");
    cases.bica::<framework::Tree100, 100, true>("100 in a tree");
    cases.bica::<framework::Active, 10, true>("10 of 10 active");
    cases.bica::<framework::Latent, 100, true>("10 of 100 active");
    #[cfg(feature = "copper")]
    cases.all.extend(crate::copper::cases()?);
    Ok(cases.all)
}

fn machines(cases: &mut Cases) {
    let (empty, sized) = ("machine of 5", "machine of 5, 20 ns");
    cases.bica::<framework::Machine, 1, false>(empty);
    cases.add::<false>("by hand", empty, ByHand::new(()));
    cases.add::<false>("by hand, timed", empty, ByHand::new(pairs::<1>()));
    cases.add::<false>("statig", empty, Statig::new());
    cases.add::<false>("smlang", empty, Smlang::new());
    cases.bica::<framework::Machine, 1, true>(sized);
    cases.add::<true>("by hand", sized, ByHand::new(()));
    cases.add::<true>("statig", sized, Statig::new());
    cases.add::<true>("smlang", sized, Smlang::new());
}

fn leaves(cases: &mut Cases) {
    let (sequence, fallback) = ("sequence of 10", "fallback of 10");
    cases.bica::<framework::Sequence, 1, false>(sequence);
    cases.add::<false>("by hand", sequence, behavior_tree::ByHand::<true>::new());
    cases.add::<false>("bonsai-bt", sequence, Bonsai::<true>::new());
    cases.bica::<framework::Fallback, 1, false>(fallback);
    cases.add::<false>("by hand", fallback, behavior_tree::ByHand::<false>::new());
    cases.add::<false>("bonsai-bt", fallback, Bonsai::<false>::new());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::compare;

    #[test]
    fn all_designs_compute_the_same_results() {
        // Several times the longest period.
        let results = compare(&mut all(false).expect("cases"), 200).expect("equal results");
        let ten = ["10 in a tree", "10 of 10 active", "10 of 100 active"].map(|workload| results[workload]);
        assert!(ten.iter().all(|result| *result == ten[0]), "{ten:?}");
    }
}
