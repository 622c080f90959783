//! Angles and poses in the plane.

use std::f32::consts::{PI, TAU};

use bica_motion::pose::wrap;
use proptest::prelude::*;

use crate::motion::cases;

proptest! {
    #![proptest_config(cases(2_000))]

    #[test]
    fn wrapped_angles_are_within_half_a_turn(bits: u32) {
        let (angle, wrapped) = (f32::from_bits(bits), wrap(f32::from_bits(bits)));
        prop_assert_eq!(wrapped.is_finite(), angle.is_finite());
        prop_assert!(!angle.is_finite() || wrapped.abs() <= PI, "{angle} is wrapped to {wrapped}");
    }

    #[test]
    fn wrapped_angles_have_the_same_direction(angle in -100.0_f32..100.0) {
        let turns = (angle - wrap(angle)) / TAU;
        prop_assert!((turns - turns.round()).abs() < 1e-5, "{angle} is wrapped to {}", wrap(angle));
    }
}
