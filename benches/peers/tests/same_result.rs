//! All who do the same work come to the same result.

use peers::boxed::Boxed;
use peers::callbacks::Callbacks;
use peers::channels::Channels;
use peers::machine::{ByHand, Smlang, Statig};
use peers::ours::{self, Ours};
use peers::part::{DIAMOND, FORWARD, Part, chain};
use peers::plain;
use peers::subject::{Subject, results};
use peers::timer::Pairs;

/// Several times the longest period.
const CYCLES: u64 = 200;

/// Compares what two subjects come to, cycle by cycle.
fn same<A: Subject, B: Subject>(left: impl Fn() -> A, right: impl Fn() -> B) {
    assert_eq!(results(&mut left(), CYCLES), results(&mut right(), CYCLES));
}

/// Compares the late-bound ways with what was written by hand.
fn late<S: Subject>(parts: &[Part], plain: impl Fn() -> S) {
    same(&plain, || Boxed::new(parts, ()));
    same(&plain, || Boxed::new(parts, Pairs::<_, 100>::new(|| 0)));
    same(&plain, || Callbacks::new(parts));
    same(&plain, || Channels::new(parts));
}

#[test]
fn of_chains() {
    late(&chain::<3>(), || plain::Chain::<_, 3>::new(()));
    late(&chain::<10>(), || plain::Chain::<_, 10>::new(()));
    late(&chain::<100>(), || plain::Chain::<_, 100>::new(()));
    same(|| plain::Chain::<_, 3>::new(()), || Ours::<ours::Chain3, _>::new(()));
    same(|| plain::Chain::<_, 10>::new(()), || Ours::<ours::Chain10, _>::new(()));
    same(|| plain::Chain::<_, 100>::new(()), || Ours::<ours::Chain100, _>::new(()));
}

#[test]
fn of_ten_among_latent_ones() {
    same(|| Ours::<ours::Active, _>::new(()), || Ours::<ours::Latent, _>::new(()));
    same(|| Ours::<ours::Active, _>::new(()), || Ours::<ours::Tree10, _>::new(()));
}

#[test]
fn of_the_diamond() {
    late(&DIAMOND, || plain::Diamond::new(()));
    same(|| plain::Diamond::new(()), || Ours::<ours::Diamond, _>::new(()));
}

#[test]
fn of_the_forward() {
    late(&FORWARD, || plain::Forward::new(()));
    same(|| plain::Forward::new(()), || Ours::<ours::Forward, _>::new(()));
}

#[test]
fn of_the_machine() {
    same(|| ByHand::new(()), || Ours::<ours::Machine, _>::new(()));
    same(|| ByHand::new(()), Statig::new);
    same(|| ByHand::new(()), Smlang::new);
}
