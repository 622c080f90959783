//! Clamping must not panic.

use bica_motion::bounds::clamp;

#[test]
fn clamp_equals_the_standard_one_for_ordered_bounds() {
    let values = [-0.0, 0.0, 0.5, -2.0, 2.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
    for (low, high) in [(0.0, 1.0), (-0.0, 0.0), (-1.5, -1.0), (f32::NEG_INFINITY, f32::INFINITY)] {
        for value in values {
            assert_eq!(clamp(value, low, high).to_bits(), value.clamp(low, high).to_bits(), "{value} {low} {high}");
        }
    }
}

#[test]
fn clamp_does_not_panic_for_unordered_or_nan_bounds() {
    assert_eq!(clamp(0.5, 1.0, 0.0).to_bits(), 1.0_f32.to_bits());
    assert_eq!(clamp(0.5, f32::NAN, f32::NAN).to_bits(), 0.5_f32.to_bits());
}
