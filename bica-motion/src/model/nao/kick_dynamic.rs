//! Kicks for a world with dynamics, with the left foot.
//!
//! They follow the pattern of the [kinematic kicks](super::kick_kinematic) at higher speed. Durations, positions and angles
//! of the diagonal and the lateral kick were found by random search in `MuJoCo`. A change was kept if the ball went farther
//! and straighter while the torso moved less.

use crate::model::KickFrame;

/// Straight ahead with the toes.
pub(super) const FRONT: [KickFrame; 7] = [
    KickFrame::new(0.40, [0.012, -0.040, 0.225], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
    KickFrame::new(0.15, [0.012, -0.042, 0.225], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.30, [-0.005, -0.045, 0.228], [-0.075, 0.055, 0.028], [0.0, 0.0, 0.10]),
    KickFrame::new(0.17, [0.032, -0.045, 0.228], [0.135, 0.056, 0.022], [0.0, 0.0, -0.10]),
    KickFrame::new(0.08, [0.032, -0.045, 0.228], [0.125, 0.056, 0.022], [0.0, 0.0, -0.10]),
    KickFrame::new(0.35, [0.012, -0.042, 0.225], [0.0, 0.055, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.20, [0.012, -0.040, 0.225], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
];

/// To the right and ahead; the toes point inwards.
pub(super) const DIAGONAL: [KickFrame; 8] = [
    KickFrame::new(0.45, [0.012, -0.040, 0.225], [0.0, 0.050, 0.0], [0.0, -0.01, -0.02]),
    KickFrame::new(0.15, [0.012, -0.042, 0.225], [0.032, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.29, [0.0, -0.042, 0.210], [0.018, 0.122, 0.025], [-0.67, 0.22, 0.0]),
    KickFrame::new(0.14, [0.030, -0.048, 0.231], [0.097, 0.042, 0.025], [-0.58, 0.15, 0.0]),
    KickFrame::new(0.05, [0.030, -0.048, 0.225], [0.093, 0.042, 0.025], [-0.58, 0.15, -0.03]),
    KickFrame::new(0.35, [0.013, -0.040, 0.219], [0.020, 0.092, 0.022], [-0.27, 0.10, -0.09]),
    KickFrame::new(0.20, [0.012, -0.040, 0.225], [0.0, 0.050, 0.020], [0.0, 0.0, 0.0]),
    KickFrame::new(0.21, [0.012, -0.040, 0.225], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
];

/// To the right with the inner edge of the foot, in front of the right foot's toes.
pub(super) const LATERAL: [KickFrame; 7] = [
    KickFrame::new(0.40, [0.004, -0.040, 0.225], [0.0, 0.050, 0.0], [0.0, 0.0, 0.0]),
    KickFrame::new(0.15, [0.012, -0.042, 0.225], [0.0, 0.050, 0.020], [0.0, -0.05, 0.0]),
    KickFrame::new(0.36, [0.012, -0.042, 0.236], [0.095, 0.111, 0.025], [0.20, 0.31, 0.0]),
    KickFrame::new(0.14, [0.012, -0.052, 0.224], [0.084, 0.028, 0.025], [-0.17, 0.06, -0.02]),
    KickFrame::new(0.05, [0.012, -0.052, 0.219], [0.115, 0.035, 0.025], [-0.22, 0.06, 0.0]),
    KickFrame::new(0.35, [0.012, -0.040, 0.226], [0.0, 0.056, 0.008], [0.0, 0.0, 0.05]),
    KickFrame::new(0.22, [0.012, -0.051, 0.225], [0.049, 0.050, 0.0], [0.0, 0.0, 0.0]),
];
