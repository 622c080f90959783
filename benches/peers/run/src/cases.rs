//! All combinations of a design and a workload that are measured.

use peers::boxed::Boxed;
use peers::callbacks::Callbacks;
use peers::channels::Channels;
use peers::framework::{self, BicaSubject};
use peers::machine::{ByHand, Smlang, Statig};
use peers::part::{DIAMOND, FORWARD, Part, chain};
use peers::plain;
use peers::report::figures::{Design, Workload};
use peers::timer::Pairs;
use peers_copper::{RobotClock, read_raw_counter};

use bica::Stopwatch;

use crate::case::Case;
use crate::slow::SlowProbe;

/// Creates all cases; with `slow`, those of BICA contain an artificial slowdown.
///
/// # Errors
/// If Copper rejects an application.
pub fn all(slow: bool) -> Result<Vec<Case>, String> {
    let mut cases = bica(slow);
    cases.extend(copper(Design::Copper, &RobotClock::new())?);
    cases.extend(copper(Design::CopperMocked, &RobotClock::mock().0)?);
    cases.extend(by_hand());
    cases.extend(inlined());
    cases.extend(late());
    cases.extend(sized());
    cases.push(Case::new(Design::Statig, Workload::Machine, Statig::new()));
    cases.push(Case::new(Design::Smlang, Workload::Machine, Smlang::new()));
    Ok(cases)
}

/// Adds the cases of a tree with the given number of components: without a probe, and with a stopwatch that reads the
/// counter that Copper reads. With `slow`, each also has a probe that takes time.
macro_rules! bica {
    ($cases:ident, $slow:ident: $($workload:ident $tree:ident of $count:literal,)*) => {
        $({
            let (workload, watch) = (Workload::$workload, Stopwatch::<_, $count>::new(read_raw_counter));
            $cases.extend(if $slow {
                [
                    Case::new(Design::Bica, workload, BicaSubject::<framework::$tree, _>::new(SlowProbe::<$count>)),
                    Case::new(Design::BicaTimed, workload, BicaSubject::<framework::$tree, _>::new((watch, SlowProbe::<$count>))),
                ]
            } else {
                [
                    Case::new(Design::Bica, workload, BicaSubject::<framework::$tree, _>::new(())),
                    Case::new(Design::BicaTimed, workload, BicaSubject::<framework::$tree, _>::new(watch)),
                ]
            });
        })*
    };
}

fn bica(slow: bool) -> Vec<Case> {
    let mut cases = Vec::new();
    bica! { cases, slow:
        Chain3 Chain3 of 3, Chain10 Chain10 of 10, Chain100 Chain100 of 100, Diamond Diamond of 4,
        Machine Machine of 1, Forward Forward of 25,
        SizedChain10 Chain10 of 10, SizedMachine Machine of 1, SizedForward Forward of 25,
        Tree10 Tree10 of 10, Tree100 Tree100 of 100, Active Active of 10, Latent Latent of 100,
    }
    cases
}

fn copper(design: Design, clock: &RobotClock) -> Result<Vec<Case>, String> {
    let refused = |error| format!("copper-rs failed to start: {error}");
    Ok(vec![
        Case::new(design, Workload::Chain3, peers_copper::chain_3(clock.clone()).map_err(refused)?),
        Case::new(design, Workload::Chain10, peers_copper::chain_10(clock.clone()).map_err(refused)?),
        Case::new(design, Workload::Chain100, peers_copper::chain_100(clock.clone()).map_err(refused)?),
        Case::new(design, Workload::Diamond, peers_copper::diamond(clock.clone()).map_err(refused)?),
        Case::new(design, Workload::Forward, peers_copper::forward(clock.clone()).map_err(refused)?),
    ])
}

fn by_hand() -> Vec<Case> {
    let (quiet, timed) = (Design::ByHand, Design::ByHandTimed);
    vec![
        Case::new(quiet, Workload::Chain3, plain::Chain::<_, 3, false>::new(())),
        Case::new(timed, Workload::Chain3, plain::Chain::<_, 3, false>::new(pairs::<3>())),
        Case::new(quiet, Workload::Chain10, plain::Chain::<_, 10, false>::new(())),
        Case::new(timed, Workload::Chain10, plain::Chain::<_, 10, false>::new(pairs::<10>())),
        Case::new(quiet, Workload::Chain100, plain::Chain::<_, 100, false>::new(())),
        Case::new(timed, Workload::Chain100, plain::Chain::<_, 100, false>::new(pairs::<100>())),
        Case::new(quiet, Workload::Diamond, plain::Diamond::<_, false>::new(())),
        Case::new(timed, Workload::Diamond, plain::Diamond::<_, false>::new(pairs::<4>())),
        Case::new(quiet, Workload::Machine, ByHand::new(())),
        Case::new(timed, Workload::Machine, ByHand::new(pairs::<1>())),
        Case::new(quiet, Workload::Forward, plain::Forward::<_, false>::new(())),
        Case::new(timed, Workload::Forward, plain::Forward::<_, false>::new(pairs::<25>())),
    ]
}

fn inlined() -> Vec<Case> {
    let inlined = Design::ByHandInlined;
    vec![
        Case::new(inlined, Workload::Chain3, plain::Chain::<_, 3, true>::new(())),
        Case::new(inlined, Workload::Chain10, plain::Chain::<_, 10, true>::new(())),
        Case::new(inlined, Workload::Chain100, plain::Chain::<_, 100, true>::new(())),
        Case::new(inlined, Workload::Diamond, plain::Diamond::<_, true>::new(())),
        Case::new(inlined, Workload::Forward, plain::Forward::<_, true>::new(())),
    ]
}

/// The other designs with steps of realistic size.
fn sized() -> Vec<Case> {
    vec![
        Case::new(Design::ByHand, Workload::SizedChain10, plain::Chain::<_, 10, false>::new(())),
        Case::new(Design::ByHandInlined, Workload::SizedChain10, plain::Chain::<_, 10, true>::new(())),
        Case::new(Design::Boxed, Workload::SizedChain10, Boxed::new(&chain::<10>(), ())),
        Case::new(Design::ByHand, Workload::SizedForward, plain::Forward::<_, false>::new(())),
        Case::new(Design::ByHandInlined, Workload::SizedForward, plain::Forward::<_, true>::new(())),
        Case::new(Design::Boxed, Workload::SizedForward, Boxed::new(&FORWARD, ())),
        Case::new(Design::ByHand, Workload::SizedMachine, ByHand::new(())),
        Case::new(Design::Statig, Workload::SizedMachine, Statig::new()),
        Case::new(Design::Smlang, Workload::SizedMachine, Smlang::new()),
    ]
}

fn late() -> Vec<Case> {
    let graphs: [(Workload, &[Part]); 5] = [
        (Workload::Chain3, &chain::<3>()),
        (Workload::Chain10, &chain::<10>()),
        (Workload::Chain100, &chain::<100>()),
        (Workload::Diamond, &DIAMOND),
        (Workload::Forward, &FORWARD),
    ];
    let each = graphs.into_iter().map(|(workload, parts)| {
        [
            Case::new(Design::Boxed, workload, Boxed::new(parts, ())),
            Case::new(Design::BoxedTimed, workload, Boxed::new(parts, pairs::<100>())),
            Case::new(Design::Callbacks, workload, Callbacks::new(parts)),
            Case::new(Design::Channels, workload, Channels::new(parts)),
        ]
    });
    each.flatten().collect()
}

/// Timer that reads the counter that Copper reads before and after each component.
fn pairs<const N: usize>() -> Pairs<fn() -> u64, N> {
    Pairs::new(read_raw_counter)
}
