//! All designs compute the same results.

use peers::boxed::Boxed;
use peers::callbacks::Callbacks;
use peers::channels::Channels;
use peers::framework::{self, BicaSubject};
use peers::machine::{ByHand, Smlang, Statig};
use peers::part::{DIAMOND, FORWARD, Part, chain};
use peers::plain;
use peers::subject::{Subject, results};
use peers::timer::Pairs;

/// Several times the longest period.
const CYCLES: u64 = 200;

/// Compares the results of two subjects, cycle by cycle.
fn same<A: Subject, B: Subject>(left: impl Fn() -> A, right: impl Fn() -> B) {
    assert_eq!(results(&mut left(), CYCLES), results(&mut right(), CYCLES));
}

/// Compares the late-bound designs with the one written by hand.
fn late<S: Subject>(parts: &[Part], plain: impl Fn() -> S) {
    same(&plain, || Boxed::new(parts, ()));
    same(&plain, || Boxed::new(parts, Pairs::<_, 100>::new(|| 0)));
    same(&plain, || Callbacks::new(parts));
    same(&plain, || Channels::new(parts));
}

#[test]
fn chains_agree() {
    late(&chain::<3>(), || plain::Chain::<_, 3, false>::new(()));
    late(&chain::<10>(), || plain::Chain::<_, 10, false>::new(()));
    late(&chain::<100>(), || plain::Chain::<_, 100, false>::new(()));
    same(|| plain::Chain::<_, 3, false>::new(()), || BicaSubject::<framework::Chain3, _>::new(()));
    same(|| plain::Chain::<_, 10, false>::new(()), || BicaSubject::<framework::Chain10, _>::new(()));
    same(|| plain::Chain::<_, 100, false>::new(()), || BicaSubject::<framework::Chain100, _>::new(()));
}

#[test]
fn ten_components_agree_with_and_without_latent_ones() {
    same(|| BicaSubject::<framework::Active, _>::new(()), || BicaSubject::<framework::Latent, _>::new(()));
    same(|| BicaSubject::<framework::Active, _>::new(()), || BicaSubject::<framework::Tree10, _>::new(()));
}

#[test]
fn diamonds_agree() {
    late(&DIAMOND, || plain::Diamond::<_, false>::new(()));
    same(|| plain::Diamond::<_, false>::new(()), || BicaSubject::<framework::Diamond, _>::new(()));
}

#[test]
fn forwards_agree() {
    late(&FORWARD, || plain::Forward::<_, false>::new(()));
    same(|| plain::Forward::<_, false>::new(()), || BicaSubject::<framework::Forward, _>::new(()));
}

#[test]
fn functions_by_hand_agree_with_inlined_ones() {
    same(|| plain::Chain::<_, 3, false>::new(()), || plain::Chain::<_, 3, true>::new(()));
    same(|| plain::Chain::<_, 10, false>::new(()), || plain::Chain::<_, 10, true>::new(()));
    same(|| plain::Chain::<_, 100, false>::new(()), || plain::Chain::<_, 100, true>::new(()));
    same(|| plain::Diamond::<_, false>::new(()), || plain::Diamond::<_, true>::new(()));
    same(|| plain::Forward::<_, false>::new(()), || plain::Forward::<_, true>::new(()));
}

#[test]
fn machines_agree() {
    same(|| ByHand::new(()), || BicaSubject::<framework::Machine, _>::new(()));
    same(|| ByHand::new(()), Statig::new);
    same(|| ByHand::new(()), Smlang::new);
}
