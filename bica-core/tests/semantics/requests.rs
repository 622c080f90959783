//! What each request of a rate gives, for every class of bit patterns.

use proptest::prelude::*;

use super::*;

pub(crate) struct Declared;

#[component(hz = 50, crate = bica_core)]
impl Declared {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, _: &mut Free) {}
}

pub(crate) struct Free;

#[component(crate = bica_core)]
impl Free {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    pub(crate) struct Requests { root: Declared, cycle_hz: 100, components: [Declared, Free], crate: bica_core }
}

/// What a request gives.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Given {
    /// The declared rate.
    Declared,
    /// Zero, without a sign.
    Rest,
    /// The declared rate if there is one, and else what was requested.
    AtMostDeclared,
    /// What was requested.
    Requested,
}

/// The bits of 50.0.
const FIFTY: u32 = 0x4248_0000;

/// The first and last bit pattern of each class, in the order of the patterns; together they are all patterns.
const CLASSES: [(&str, u32, u32, Given); 10] = [
    ("0", 0x0000_0000, 0x0000_0000, Given::Rest),
    ("subnormal", 0x0000_0001, 0x007f_ffff, Given::Requested),
    ("normal, up to the declared rate", 0x0080_0000, FIFTY, Given::Requested),
    ("above the declared rate", FIFTY + 1, 0x7f7f_ffff, Given::AtMostDeclared),
    ("infinite", 0x7f80_0000, 0x7f80_0000, Given::AtMostDeclared),
    ("NaN", 0x7f80_0001, 0x7fff_ffff, Given::Declared),
    ("-0", 0x8000_0000, 0x8000_0000, Given::Rest),
    ("negative", 0x8000_0001, 0xff7f_ffff, Given::Rest),
    ("negative infinite", 0xff80_0000, 0xff80_0000, Given::Rest),
    ("NaN with a sign", 0xff80_0001, 0xffff_ffff, Given::Declared),
];

/// Bits of the rate of a component after a request; `None` is every cycle.
fn bits(hz: Option<f32>) -> Option<u32> {
    hz.map(f32::to_bits)
}

fn check(name: &str, request: u32, given: Given) -> Result<(), TestCaseError> {
    let mut tree = Requests::new();
    // What held before makes no difference.
    for before in [50.0, 0.0, 7.5] {
        tree.rate_mut::<Declared>().set(before);
        tree.rate_mut::<Free>().set(before);
        tree.rate_mut::<Declared>().set(f32::from_bits(request));
        tree.rate_mut::<Free>().set(f32::from_bits(request));
        let (declared, free) = match given {
            Given::Declared => (Some(FIFTY), None),
            Given::Rest => (Some(0), Some(0)),
            Given::AtMostDeclared => (Some(FIFTY), Some(request)),
            Given::Requested => (Some(request), Some(request)),
        };
        prop_assert_eq!(bits(tree.rate::<Declared>().hz()), declared, "{}: {:#010x}", name, request);
        prop_assert_eq!(bits(tree.rate::<Free>().hz()), free, "{}: {:#010x}", name, request);
    }
    Ok(())
}

#[test]
fn the_classes_are_all_bit_patterns() {
    for pair in CLASSES.windows(2) {
        assert_eq!(pair[0].2 + 1, pair[1].1);
    }
    assert_eq!((CLASSES[0].1, CLASSES[9].2), (0, u32::MAX));
}

#[test]
fn each_class_gives_what_is_documented_at_its_ends() {
    for (name, first, last, given) in CLASSES {
        for request in [first, last] {
            check(name, request, given).unwrap();
        }
    }
}

#[test]
fn a_request_at_rest_never_runs() {
    for request in [0x0000_0000, 0x8000_0000, 0x0000_0001, 0x007f_ffff, 0xff80_0000, 0x8000_0001, 0xbf80_0000] {
        let mut tree = Requests::new();
        tree.tick(at(0));
        tree.rate_mut::<Declared>().set(f32::from_bits(request));
        tree.rate_mut::<Free>().set(f32::from_bits(request));
        for ms in [10, 20, 1_000_000, 31_536_000_000] {
            assert_eq!(runs(&mut tree, ms), [""; 0], "{request:#010x}");
        }
    }
}

#[test]
fn an_infinite_request_without_a_declared_rate_runs_in_every_cycle() {
    let mut tree = Requests::new();
    tree.rate_mut::<Free>().set(f32::INFINITY);
    tree.tick(at(0));
    assert_eq!(runs(&mut tree, 1), ["Free"]);
    assert_eq!(runs(&mut tree, 1), ["Free"]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn each_class_gives_what_is_documented(class in 0..CLASSES.len(), which: u32) {
        let (name, first, last, given) = CLASSES[class];
        let request = first + (u64::from(which) % (u64::from(last - first) + 1)) as u32;
        check(name, request, given)?;
    }
}
