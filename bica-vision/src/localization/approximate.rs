//! Approximations of mathematical functions, for the loop over the particles.
//!
//! On a microcontroller without instructions for them, the functions of a library take a hundred instructions each,
//! because they are exact to the last digit. These take 10 to 20. Their errors are far below the errors of a sighting.
//! They only add, multiply and divide, so results are equal on all processors.

use core::f32::consts::{FRAC_2_PI, FRAC_PI_2, LN_2, SQRT_2};

use glam::Vec2;

/// Unit vector at an angle of −10 to 10 rad: its cosine and sine, within 10⁻⁶.
pub(super) fn direction(angle: f32) -> Vec2 {
    let quarters = (FRAC_2_PI * angle + 0.5_f32.copysign(angle)) as i32;
    let rest = angle - FRAC_PI_2 * quarters as f32;
    let square = rest * rest;
    // Polynomials of the Cephes library (Moshier 1992) for −π/4 to π/4.
    let sine = rest + rest * square * (-0.166_666_55 + square * (0.008_332_161 - 0.000_195_152_96 * square));
    let cosine = 1.0 - square * (0.5 - square * (0.041_666_646 - square * (0.001_388_731_6 - 2.443_315_7e-5 * square)));
    match quarters & 3 {
        0 => Vec2::new(cosine, sine),
        1 => Vec2::new(-sine, cosine),
        2 => Vec2::new(-cosine, -sine),
        _ => Vec2::new(sine, -cosine),
    }
}

/// Square root of a number that is not negative, within 10⁻⁵ of it.
pub(super) fn sqrt(value: f32) -> f32 {
    // The exponent of the inverse root is minus half the exponent (Lomont 2003, "Fast Inverse Square Root"); each step of
    // Newton's method squares the error.
    let inverse = f32::from_bits(0x5F37_59DF - (value.to_bits() >> 1));
    let inverse = inverse * (1.5 - 0.5 * value * inverse * inverse);
    value * inverse * (1.5 - 0.5 * value * inverse * inverse)
}

/// Binary logarithm of a normal positive number, within 10⁻⁵.
pub(super) fn log2(value: f32) -> f32 {
    let bits = value.to_bits();
    let exponent = (bits >> 23) as i32 - 127;
    let mantissa = f32::from_bits(bits & 0x007F_FFFF | 0x3F80_0000);
    // Series of the inverse hyperbolic tangent about the middle of the range, √2.
    let part = (mantissa - SQRT_2) / (mantissa + SQRT_2);
    let square = part * part;
    exponent as f32 + 0.5 + 2.0 / LN_2 * part * (1.0 + square * (1.0 / 3.0 + 0.2 * square))
}

/// Power of two with an exponent of at most 100, within 10⁻⁵ of it; 0 below 2⁻¹²⁶.
pub(super) fn exp2(exponent: f32) -> f32 {
    if exponent < -126.0 {
        return 0.0;
    }
    let whole = (exponent + 0.5_f32.copysign(exponent)) as i32;
    let rest = LN_2 * (exponent - whole as f32);
    let series = 1.0 + rest * (1.0 + rest * (0.5 + rest * (1.0 / 6.0 + rest * (1.0 / 24.0 + rest / 120.0))));
    series * f32::from_bits(((whole + 127) as u32) << 23)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from `from` to `to`.
    fn range(from: f32, to: f32) -> impl Iterator<Item = f32> {
        (0..=20_000_u16).map(move |at| from + (to - from) * f32::from(at) / 20_000.0)
    }

    #[test]
    fn directions_are_cosines_and_sines() {
        for angle in range(-10.0, 10.0) {
            let exact = Vec2::new(libm::cosf(angle), libm::sinf(angle));
            assert!((direction(angle) - exact).abs().max_element() < 1e-6, "at {angle}");
        }
    }

    #[test]
    fn square_roots_are_exact_to_five_digits() {
        for exponent in range(-100.0, 100.0) {
            let value = libm::exp2f(exponent);
            assert!((sqrt(value) / libm::sqrtf(value) - 1.0).abs() < 1e-5, "of {value}");
        }
        assert!(sqrt(0.0).abs() < 1e-30);
    }

    #[test]
    fn logarithms_and_powers_are_exact_to_five_digits() {
        for exponent in range(-125.0, 100.0) {
            assert!((log2(libm::exp2f(exponent)) - exponent).abs() < 1e-5 + 1e-7 * exponent.abs(), "of 2^{exponent}");
            assert!((exp2(exponent) / libm::exp2f(exponent) - 1.0).abs() < 1e-5, "2^{exponent}");
        }
        assert!(exp2(-200.0).abs() < 1e-38 && exp2(f32::NEG_INFINITY).abs() < 1e-38);
    }
}
