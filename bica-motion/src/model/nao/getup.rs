//! Key postures of getting up and of turning over.
//!
//! Sources: rUNSWift 2022 `getupFront.pos`, `getupBack.pos` and `getupBackSlow.pos`, made for real robots. The way up from
//! the front and the rise were optimised in `MuJoCo` by an evolution strategy (separable CMA-ES, Ros and Hansen 2008) over
//! several sole frictions, motor strengths, gains and noise. The ways to turn over were found there by the cross-entropy
//! method (Rubinstein 1999) over several sole frictions.

use crate::model::{GetUpFrame, GetUpFrames};

/// All key postures.
pub(super) const GET_UP: GetUpFrames = GetUpFrames {
    sit_up_from_front: &SIT_UP_FROM_FRONT,
    sit_up_from_back: &SIT_UP_FROM_BACK,
    sit_up_from_side: &[],
    rise: &RISE,
    turn_from_front: &TURN_FROM_FRONT,
    turn_from_back: &TURN_FROM_BACK,
    rolled_onto_back: 2,
};

/// From lying on the front to sitting with spread legs.
const SIT_UP_FROM_FRONT: [GetUpFrame; 14] = [
    GetUpFrame::new(36, [0, 29, 90, 10, 0, -2, 0, 0, 0, 0, 0, 30, 0, 0, 0, 0, 30, 0, 90, -10, 0, 2, 0]),
    GetUpFrame::new(40, [0, 29, 89, 76, 0, -2, 0, -65, 45, 27, 30, -30, 0, -45, 27, 30, -30, 0, 89, -76, 0, 2, 0]),
    GetUpFrame::new(
        61,
        [0, 28, -95, -14, -92, -2, 0, -65, 44, -52, -2, -31, 19, -45, -42, 5, -33, -20, -89, 2, 87, 2, 0],
    ),
    GetUpFrame::new(
        37,
        [0, 29, -43, -1, -90, -26, 0, -65, 45, -81, -5, -5, 2, -1, -88, -3, -5, -4, -46, -11, 84, 35, 0],
    ),
    GetUpFrame::new(60, [0, 29, 42, -1, -77, -2, 0, -59, -15, -47, 3, 9, 1, 14, -41, -5, 8, 6, 32, -1, 71, 2, 0]),
    GetUpFrame::new(55, [0, 29, 28, 30, -58, -88, 0, -65, -17, -34, 2, 16, 1, 10, -40, -5, 10, -6, 37, -19, 70, 88, 0]),
    GetUpFrame::new(24, [0, 29, -86, 72, -19, -88, 0, -65, -18, -60, -5, 9, 3, 18, -54, -5, 9, 1, -67, -75, 28, 82, 0]),
    GetUpFrame::new(
        29,
        [0, 29, -65, 73, -17, -25, 0, -65, -17, -54, -3, 52, -1, 19, -55, -5, 52, 2, -71, -76, 25, 22, 0],
    ),
    GetUpFrame::new(40, [0, 29, 71, 72, -29, -10, 0, -64, -11, -54, -1, 52, 3, 11, -58, -5, 52, 1, 66, -58, 21, 10, 0]),
    GetUpFrame::new(
        22,
        [0, 26, 111, 37, 24, -21, 0, -65, -9, -57, -5, 52, 1, 15, -57, -5, 52, 1, 108, -36, -20, 24, 0],
    ),
    GetUpFrame::new(
        71,
        [0, -20, 119, -18, 15, -11, 0, -65, 30, -88, 80, 26, -8, -34, -87, 74, 52, 12, 119, -4, -24, 19, 0],
    ),
    GetUpFrame::new(
        25,
        [0, -21, 119, -5, 30, -14, 0, -65, 26, -88, 76, 26, -6, -31, -88, 75, 52, 8, 119, -3, -29, 15, 0],
    ),
    GetUpFrame::new(50, [0, -29, 115, 0, 20, -20, 0, -30, 0, -70, 0, 52, 0, 0, -70, 0, 52, 0, 115, 0, -20, 20, 0]),
    GetUpFrame::new(10, [0, -29, 115, 0, 20, -20, 0, -30, 0, -70, 0, 52, 0, 0, -70, 0, 52, 0, 115, 0, -20, 20, 0]),
];

/// From lying on the back to sitting.
const SIT_UP_FROM_BACK: [GetUpFrame; 4] = [
    GetUpFrame::new(60, [0, -10, 90, 30, 0, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 90, -30, 0, 2, 0]),
    GetUpFrame::new(40, [0, -29, 119, 12, 5, -85, 0, 0, 0, 25, 35, 50, 0, 0, 25, 35, 50, 0, 119, -12, -5, 85, 0]),
    GetUpFrame::new(40, [0, -29, 119, 12, 20, -85, 0, 0, 0, -55, 57, 52, 0, 0, -55, 57, 52, 0, 119, -12, -20, 85, 0]),
    GetUpFrame::new(40, [0, -29, 115, 0, 20, -20, 0, -30, 0, -70, 0, 52, 0, 0, -70, 0, 52, 0, 115, 0, -20, 20, 0]),
];

/// From sitting to a deep crouch.
const RISE: [GetUpFrame; 10] = [
    GetUpFrame::new(
        41,
        [0, -21, 119, -12, 18, -11, 0, -65, 28, -88, 91, 16, -3, -32, -87, 85, 48, 14, 119, -2, -26, 19, 0],
    ),
    GetUpFrame::new(
        10,
        [0, 29, 119, -18, 17, -3, 0, -65, 21, -75, 113, 19, -1, -27, -80, 30, 44, 10, 114, -22, -35, 10, 0],
    ),
    GetUpFrame::new(
        24,
        [0, 29, 119, -6, 34, -2, 0, -65, 29, -41, 121, -20, -3, -39, -68, 26, 52, 9, 119, -18, -11, 2, 0],
    ),
    GetUpFrame::new(
        20,
        [0, 25, 117, -1, 22, -23, 0, -60, 10, -9, 121, -43, -22, -40, -88, 45, 52, -2, 119, -11, -21, 2, 0],
    ),
    GetUpFrame::new(
        22,
        [0, 23, 112, 0, 5, -5, 0, -65, -1, -23, 109, -41, -7, -30, -63, 44, 52, 9, 109, -15, -28, 2, 0],
    ),
    GetUpFrame::new(
        16,
        [0, 29, 110, -17, 28, -16, 0, -62, 27, -18, 115, -67, -14, -28, -59, 45, 26, 0, 119, 2, -17, 3, 0],
    ),
    GetUpFrame::new(
        17,
        [0, 29, 93, -8, 11, -19, 0, -47, 23, -19, 108, -63, -2, -42, -17, 27, 46, 1, 119, -2, -39, 3, 0],
    ),
    GetUpFrame::new(
        57,
        [0, 28, 119, -1, 42, -2, 0, -59, 23, -34, 107, -67, 4, -9, -38, 87, -4, 0, 119, -33, -37, 3, 0],
    ),
    GetUpFrame::new(
        25,
        [0, 22, 103, -18, 11, -10, 0, -57, 26, -13, 121, -63, 2, -32, -11, 121, -64, 4, 109, -18, -19, 2, 0],
    ),
    GetUpFrame::new(
        28,
        [0, 27, 107, 18, 30, -20, 0, -5, -4, -47, 110, -67, -8, 15, -57, 112, -55, 12, 119, -22, -23, 10, 0],
    ),
];

/// From lying on the front to lying on the back.
const TURN_FROM_FRONT: [GetUpFrame; 3] = [
    GetUpFrame::new(46, [0, 0, 88, -3, -5, -15, 0, -9, 10, -25, 39, 52, 0, 21, -21, 3, 33, 0, 38, -33, 23, 33, 0]),
    GetUpFrame::new(35, [0, 0, 51, 32, 17, -47, 0, 5, 26, -66, -5, -40, 0, 16, -25, 14, -50, 0, 58, 12, 18, 88, 0]),
    GetUpFrame::new(35, [0, 0, 109, -11, -48, -11, 0, -11, -21, -62, 11, 3, 0, 21, -23, 34, -8, 0, -3, 18, 72, 55, 0]),
];

/// From lying on the back to lying on the front.
const TURN_FROM_BACK: [GetUpFrame; 3] = [
    GetUpFrame::new(27, [0, 0, 79, 12, -5, -27, 0, 14, -13, -18, 63, -68, 0, 10, 27, 3, 27, 0, 59, 18, -17, 56, 0]),
    GetUpFrame::new(25, [0, 0, 72, 76, -11, -2, 0, 24, 20, -80, 19, 6, 0, -16, 27, 43, -14, 0, 40, -33, 19, 27, 0]),
    GetUpFrame::new(51, [0, 0, -61, -18, -18, -12, 0, 2, -21, -28, 45, 0, 0, 21, 27, 46, -30, 0, 65, -12, 2, 5, 0]),
];
