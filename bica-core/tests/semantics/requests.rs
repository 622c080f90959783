//! Rate after a request, for every class of bit patterns.

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

/// Resulting rate.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Expected {
    /// The declared rate.
    Declared,
    /// Zero, without a sign.
    Zero,
    /// The declared rate if there is one, otherwise the requested one.
    AtMostDeclared,
    /// The requested rate.
    Requested,
}

/// Bits of 50.0.
const FIFTY: u32 = 0x4248_0000;

/// First and last bit pattern of each class, in ascending order. Together the classes contain all patterns.
const CLASSES: [(&str, u32, u32, Expected); 10] = [
    ("0", 0x0000_0000, 0x0000_0000, Expected::Zero),
    ("subnormal", 0x0000_0001, 0x007f_ffff, Expected::Requested),
    ("normal, up to the declared rate", 0x0080_0000, FIFTY, Expected::Requested),
    ("above the declared rate", FIFTY + 1, 0x7f7f_ffff, Expected::AtMostDeclared),
    ("infinite", 0x7f80_0000, 0x7f80_0000, Expected::AtMostDeclared),
    ("NaN", 0x7f80_0001, 0x7fff_ffff, Expected::Declared),
    ("-0", 0x8000_0000, 0x8000_0000, Expected::Zero),
    ("negative", 0x8000_0001, 0xff7f_ffff, Expected::Zero),
    ("negative infinite", 0xff80_0000, 0xff80_0000, Expected::Zero),
    ("NaN with a sign", 0xff80_0001, 0xffff_ffff, Expected::Declared),
];

/// Bits of the rate of a component after a request; `None` means every cycle.
fn bits(hz: Option<f32>) -> Option<u32> {
    hz.map(f32::to_bits)
}

fn check(name: &str, request: u32, expected: Expected) -> Result<(), TestCaseError> {
    let mut tree = Requests::new();
    // The previous rate has no effect.
    for before in [50.0, 0.0, 7.5] {
        tree.rate_mut::<Declared>().set(before);
        tree.rate_mut::<Free>().set(before);
        tree.rate_mut::<Declared>().set(f32::from_bits(request));
        tree.rate_mut::<Free>().set(f32::from_bits(request));
        let (declared, free) = match expected {
            Expected::Declared => (Some(FIFTY), None),
            Expected::Zero => (Some(0), Some(0)),
            Expected::AtMostDeclared => (Some(FIFTY), Some(request)),
            Expected::Requested => (Some(request), Some(request)),
        };
        prop_assert_eq!(bits(tree.rate::<Declared>().hz()), declared, "{}: {:#010x}", name, request);
        prop_assert_eq!(bits(tree.rate::<Free>().hz()), free, "{}: {:#010x}", name, request);
    }
    Ok(())
}

#[test]
fn the_classes_contain_all_bit_patterns() {
    for pair in CLASSES.windows(2) {
        assert_eq!(pair[0].2 + 1, pair[1].1);
    }
    assert_eq!((CLASSES[0].1, CLASSES[9].2), (0, u32::MAX));
}

#[test]
fn the_bounds_of_each_class_give_the_documented_rate() {
    for (name, first, last, expected) in CLASSES {
        for request in [first, last] {
            check(name, request, expected).unwrap();
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn each_class_gives_the_documented_rate(class in 0..CLASSES.len(), which: u32) {
        let (name, first, last, expected) = CLASSES[class];
        let request = first + (u64::from(which) % (u64::from(last - first) + 1)) as u32;
        check(name, request, expected)?;
    }
}
