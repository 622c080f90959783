//! Clamping without a panic.

/// Nearest value to `value` in `low..=high`; NaN stays NaN.
///
/// Like `f32::clamp`, but bounds in the wrong order return one of them instead of a panic. The message of that panic
/// would link the formatting of floats, 13 KiB, into a microcontroller's program.
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
