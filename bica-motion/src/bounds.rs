//! Between two bounds.

/// The nearest value from `low` to `high`; what is no number stays so.
///
/// As `f32::clamp`, but bounds in the wrong order give one of them instead of a panic, whose message would bring the
/// formatting of floats, 13 KiB, into a microcontroller's program.
#[must_use]
pub const fn clamp(value: f32, low: f32, high: f32) -> f32 {
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::clamp;

    #[test]
    fn it_is_clamp_where_clamp_does_not_panic() {
        let values = [-0.0, 0.0, 0.5, -2.0, 2.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
        for (low, high) in [(0.0, 1.0), (-0.0, 0.0), (-1.5, -1.0), (f32::NEG_INFINITY, f32::INFINITY)] {
            for value in values {
                assert_eq!(clamp(value, low, high).to_bits(), value.clamp(low, high).to_bits(), "{value} {low} {high}");
            }
        }
        assert_eq!(clamp(0.5, 1.0, 0.0).to_bits(), 1.0_f32.to_bits());
        assert_eq!(clamp(0.5, f32::NAN, f32::NAN).to_bits(), 0.5_f32.to_bits());
    }
}
