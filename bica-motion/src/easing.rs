//! Curves from 0 to 1.

/// From rest to rest: 3x² − 2x³; stays at its ends outside of 0..1.
pub(crate) fn smooth(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Up and down again from rest to rest, 1 in the middle: 16x²(1 − x)²; 0 outside of 0..1.
pub(crate) fn bump(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    let half = x * (1.0 - x);
    16.0 * half * half
}

/// From rest to rest: gathers speed in the first fifth, loses it in the last, in between as slow as that allows.
pub(crate) fn glide(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    let half = |x: f32| if x < 0.2 { x * x / 0.32 } else { (x - 0.1) / 0.8 };
    if x < 0.5 { half(x) } else { 1.0 - half(1.0 - x) }
}

/// The value at `share` of the way from `a` to `b`.
pub(crate) fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}
