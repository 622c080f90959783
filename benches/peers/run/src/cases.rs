//! Who does what.

use peers::boxed::Boxed;
use peers::callbacks::Callbacks;
use peers::channels::Channels;
use peers::machine::{ByHand, Smlang, Statig};
use peers::ours::{self, Ours};
use peers::part::{DIAMOND, FORWARD, Part, chain};
use peers::plain;
use peers::report::figures::{Way, Work};
use peers::timer::Pairs;
use peers_copper::{RobotClock, read_raw_counter};

use bica::Stopwatch;

use crate::slow::Dawdle;
use crate::trial::Trial;

/// All ways to do all works, at rest; ours slower than it is, if `slow`.
///
/// # Errors
/// What Copper has against its applications.
pub fn all(slow: bool) -> Result<Vec<Trial>, String> {
    let mut trials = ours(slow);
    trials.extend(copper(Way::Copper, &RobotClock::new())?);
    trials.extend(copper(Way::CopperMocked, &RobotClock::mock().0)?);
    trials.extend(by_hand());
    trials.extend(late());
    trials.push(Trial::new(Way::Statig, Work::Machine, Statig::new()));
    trials.push(Trial::new(Way::Smlang, Work::Machine, Smlang::new()));
    Ok(trials)
}

/// A tree of so many components without a probe, with a stopwatch that reads the counter that Copper reads, and each of
/// them with a probe that dawdles.
macro_rules! ours {
    ($trials:ident, $slow:ident: $($tree:ident of $count:literal,)*) => {
        $({
            let (work, watch) = (Work::$tree, Stopwatch::<_, $count>::new(read_raw_counter));
            $trials.extend(if $slow {
                [
                    Trial::new(Way::Bica, work, Ours::<ours::$tree, _>::new(Dawdle::<$count>)),
                    Trial::new(Way::BicaTimed, work, Ours::<ours::$tree, _>::new((watch, Dawdle::<$count>))),
                ]
            } else {
                [
                    Trial::new(Way::Bica, work, Ours::<ours::$tree, _>::new(())),
                    Trial::new(Way::BicaTimed, work, Ours::<ours::$tree, _>::new(watch)),
                ]
            });
        })*
    };
}

fn ours(slow: bool) -> Vec<Trial> {
    let mut trials = Vec::new();
    ours! { trials, slow:
        Chain3 of 3, Chain10 of 10, Chain100 of 100, Diamond of 4, Machine of 1, Forward of 25,
        Tree10 of 10, Tree100 of 100, Active of 10, Latent of 100,
    }
    trials
}

fn copper(way: Way, clock: &RobotClock) -> Result<Vec<Trial>, String> {
    let refused = |error| format!("copper-rs does not start: {error}");
    Ok(vec![
        Trial::new(way, Work::Chain3, peers_copper::chain_3(clock.clone()).map_err(refused)?),
        Trial::new(way, Work::Chain10, peers_copper::chain_10(clock.clone()).map_err(refused)?),
        Trial::new(way, Work::Chain100, peers_copper::chain_100(clock.clone()).map_err(refused)?),
        Trial::new(way, Work::Diamond, peers_copper::diamond(clock.clone()).map_err(refused)?),
        Trial::new(way, Work::Forward, peers_copper::forward(clock.clone()).map_err(refused)?),
    ])
}

fn by_hand() -> Vec<Trial> {
    let (quiet, timed) = (Way::ByHand, Way::ByHandTimed);
    vec![
        Trial::new(quiet, Work::Chain3, plain::Chain::<_, 3>::new(())),
        Trial::new(timed, Work::Chain3, plain::Chain::<_, 3>::new(pairs::<3>())),
        Trial::new(quiet, Work::Chain10, plain::Chain::<_, 10>::new(())),
        Trial::new(timed, Work::Chain10, plain::Chain::<_, 10>::new(pairs::<10>())),
        Trial::new(quiet, Work::Chain100, plain::Chain::<_, 100>::new(())),
        Trial::new(timed, Work::Chain100, plain::Chain::<_, 100>::new(pairs::<100>())),
        Trial::new(quiet, Work::Diamond, plain::Diamond::new(())),
        Trial::new(timed, Work::Diamond, plain::Diamond::new(pairs::<4>())),
        Trial::new(quiet, Work::Machine, ByHand::new(())),
        Trial::new(timed, Work::Machine, ByHand::new(pairs::<1>())),
        Trial::new(quiet, Work::Forward, plain::Forward::new(())),
        Trial::new(timed, Work::Forward, plain::Forward::new(pairs::<25>())),
    ]
}

fn late() -> Vec<Trial> {
    let graphs: [(Work, &[Part]); 5] = [
        (Work::Chain3, &chain::<3>()),
        (Work::Chain10, &chain::<10>()),
        (Work::Chain100, &chain::<100>()),
        (Work::Diamond, &DIAMOND),
        (Work::Forward, &FORWARD),
    ];
    let each = graphs.into_iter().map(|(work, parts)| {
        [
            Trial::new(Way::Boxed, work, Boxed::new(parts, ())),
            Trial::new(Way::BoxedTimed, work, Boxed::new(parts, pairs::<100>())),
            Trial::new(Way::Callbacks, work, Callbacks::new(parts)),
            Trial::new(Way::Channels, work, Channels::new(parts)),
        ]
    });
    each.flatten().collect()
}

/// Two readings of the counter that Copper reads.
fn pairs<const N: usize>() -> Pairs<fn() -> u64, N> {
    Pairs::new(read_raw_counter)
}
