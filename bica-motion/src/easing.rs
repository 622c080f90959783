//! Easing curves over the unit interval, and linear interpolation.

/// Smoothstep 3x² − 2x³: 0 to 1 with zero slope at both ends; constant outside 0..1.
pub(crate) fn smooth(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Bump 16x²(1 − x)²: 0 at both ends with zero slope, 1 in the middle; 0 outside 0..1.
pub(crate) fn bump(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    let half = x * (1.0 - x);
    16.0 * half * half
}

/// Trapezoidal velocity profile from 0 to 1: accelerates in the first fifth, decelerates in the last, constant between.
pub(crate) fn glide(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    let half = |x: f32| if x < 0.2 { x * x / 0.32 } else { (x - 0.1) / 0.8 };
    if x < 0.5 { half(x) } else { 1.0 - half(1.0 - x) }
}

/// Linear interpolation from `a` to `b`.
pub(crate) fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}
