//! Kicks of Booster's robots.
//!
//! Own design, from the measured path of the centre of mass over the support foot in `MuJoCo`. On the compliant legs the hips have
//! to move beyond the support foot, and come back slowly: quick hips tilt the robot over the edge of its sole. One generation of an
//! evolution strategy, with motors of 0.9 to 1.15 times the gain, then improved the kick ahead and the way onto one foot.

use glam::Vec2;

use crate::model::{KickFrame, KickPose, Kicks, Technique};

pub(super) const T1: Kicks = Kicks {
    front: Technique { ball: Vec2::new(0.217, 0.121), frames: &FRONT },
    diagonal: Technique { ball: Vec2::new(0.245, 0.125), frames: &DIAGONAL },
    lateral: Technique { ball: Vec2::new(0.185, 0.07), frames: &LATERAL },
};
pub(super) const K1: Kicks = Kicks {
    front: Technique { ball: Vec2::new(0.184, 0.097), frames: &k1(&FRONT) },
    diagonal: Technique { ball: Vec2::new(0.2, 0.03), frames: &k1(&K1_DIAGONAL) },
    lateral: Technique { ball: Vec2::new(0.163, 0.05), frames: &k1(&LATERAL) },
};

/// Straight ahead with the toes.
const FRONT: [KickFrame; 8] = kick(
    KickFrame::new(0.39, [-0.005, -0.136, 0.515], [-0.098, 0.117, 0.043], [0.01, -0.05, 0.11]),
    KickFrame::new(0.19, [0.011, -0.13, 0.515], [0.186, 0.119, 0.031], [-0.12, -0.011, -0.13]),
);
/// To the right and ahead; the toes point inwards.
const DIAGONAL: [KickFrame; 8] = kick(
    KickFrame::new(0.39, [0.0, -0.14, 0.515], [0.02, 0.2, 0.0], [-0.85, 0.0, 0.0]),
    KickFrame::new(0.18, [0.02, -0.127, 0.515], [0.19, 0.07, -0.02], [-0.95, 0.0, 0.0]),
);
/// The K1's, whose stiffer legs do not lift the foot as far.
const K1_DIAGONAL: [KickFrame; 8] = kick(
    KickFrame::new(0.39, [0.0, -0.135, 0.515], [0.02, 0.2, 0.035], [-0.8, 0.0, 0.0]),
    KickFrame::new(0.18, [0.02, -0.125, 0.515], [0.19, 0.07, 0.024], [-0.85, 0.0, 0.0]),
);
/// To the right with the inner edge of the foot, in front of the right foot's toes.
const LATERAL: [KickFrame; 8] = kick(
    KickFrame::new(0.39, [0.005, -0.145, 0.515], [0.15, 0.24, 0.04], [0.1, 0.121, 0.0]),
    KickFrame::new(0.18, [0.005, -0.125, 0.515], [0.15, 0.07, 0.035], [-0.1, 0.021, 0.0]),
);

/// A kick of the T1: onto one foot, `back`, `strike`, and to the stand.
const fn kick(back: KickFrame, strike: KickFrame) -> [KickFrame; 8] {
    const LIFTED: [f32; 3] = [0.0, -0.029, 0.0];
    [
        KickFrame::new(0.86, [-0.003, -0.119, 0.515], [0.0, 0.12, 0.0], [0.0; 3]),
        KickFrame::new(0.27, [-0.004, -0.133, 0.515], [0.0, 0.12, 0.03], LIFTED),
        back,
        strike,
        KickFrame { duration: 0.1, ..strike },
        KickFrame::new(0.52, [0.004, -0.133, 0.515], [0.005, 0.12, 0.033], LIFTED),
        KickFrame::new(0.29, [0.005, -0.125, 0.515], [0.0, 0.12, 0.0], [0.0; 3]),
        KickFrame::new(0.49, [0.005, -0.034, 0.515], [0.0, 0.12, 0.0], [0.0; 3]),
    ]
}

/// A kick of the K1: the T1's at its size. The soles lie farther ahead of the ankles.
const fn k1(frames: &[KickFrame; 8]) -> [KickFrame; 8] {
    let mut scaled = *frames;
    let mut i = 0;
    while i < frames.len() {
        let KickFrame { duration, pose: KickPose { hips, foot, yaw, roll, pitch } } = frames[i];
        let hips = [0.85 * hips.x + 0.023, 0.8 * hips.y, 0.847 * hips.z];
        let foot = [0.85 * foot.x, 0.8 * foot.y, 0.847 * foot.z];
        scaled[i] = KickFrame::new(duration, hips, foot, [yaw, roll, pitch]);
        i += 1;
    }
    scaled
}
