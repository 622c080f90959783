//! Kicks for a world without dynamics, with the left foot.
//!
//! Own design. Each kick shifts the weight over the right foot, lifts and swings the left foot back, strikes, stops and returns to
//! the stand. All motion between two poses starts and ends at rest, so the foot is fastest halfway, where it meets the ball. The
//! foot is lifted and set down vertically: a foot that moves laterally while it is loaded would drag the body along.

use crate::model::KickFrame;

/// Straight ahead with the toes.
pub(super) const FRONT: [KickFrame; 7] = [
    KickFrame::new(0.40, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
    KickFrame::new(0.15, [0.012, -0.040, 0.215], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.30, [-0.005, -0.045, 0.222], [-0.065, 0.055, 0.025], [-0.015, 0.0, 0.1]),
    KickFrame::new(0.25, [0.032, -0.045, 0.222], [0.125, 0.056, 0.022], [0.015, 0.0, -0.1]),
    KickFrame::new(0.05, [0.032, -0.045, 0.222], [0.125, 0.056, 0.022], [0.015, 0.0, -0.1]),
    KickFrame::new(0.35, [0.012, -0.040, 0.215], [0.0, 0.055, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.20, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
];

/// To the right and ahead; the toes point inwards by 45°.
pub(super) const DIAGONAL: [KickFrame; 8] = [
    KickFrame::new(0.40, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
    KickFrame::new(0.15, [0.012, -0.040, 0.215], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.30, [0.000, -0.040, 0.215], [0.018, 0.122, 0.022], [-0.6, 0.22, 0.0]),
    KickFrame::new(0.17, [0.030, -0.050, 0.215], [0.097, 0.042, 0.022], [-0.58, 0.15, 0.0]),
    KickFrame::new(0.05, [0.030, -0.050, 0.215], [0.097, 0.042, 0.022], [-0.58, 0.15, 0.0]),
    KickFrame::new(0.35, [0.012, -0.040, 0.215], [0.02, 0.10, 0.020], [-0.3, 0.1, 0.0]),
    KickFrame::new(0.20, [0.012, -0.040, 0.215], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.20, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
];

/// To the right with the inner edge of the foot, in front of the right foot's toes.
pub(super) const LATERAL: [KickFrame; 7] = [
    KickFrame::new(0.40, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
    KickFrame::new(0.15, [0.012, -0.040, 0.215], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.35, [0.012, -0.040, 0.215], [0.095, 0.105, 0.020], [0.20, 0.31, 0.0]),
    KickFrame::new(0.16, [0.012, -0.055, 0.215], [0.115, 0.032, 0.020], [-0.22, 0.06, 0.0]),
    KickFrame::new(0.05, [0.012, -0.055, 0.215], [0.115, 0.032, 0.020], [-0.22, 0.06, 0.0]),
    KickFrame::new(0.35, [0.012, -0.040, 0.215], [0.0, 0.055, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.20, [0.012, -0.040, 0.215], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
];
