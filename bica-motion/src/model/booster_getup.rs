//! Key postures of getting up of Booster's robots.
//!
//! Found in `MuJoCo` by an evolution strategy (separable CMA-ES, Ros and Hansen 2008). The start of the search from the back is
//! our own: the arms push the torso up while the hips bend, the feet come under the spread thighs, and the arms push the mass over
//! them. On its back the T1 can bend its hips by 103° only, too little for a squat with parallel thighs.

use crate::model::{GetUpFrame, GetUpFrames};

/// Those of the T1. From the front it rolls over its right side onto its back first: its arms are too weak for the way over the knees.
pub(super) const T1: GetUpFrames = GetUpFrames {
    sit_up_from_front: &SQUAT_FROM_FRONT,
    sit_up_from_back: SQUAT_FROM_FRONT.split_at(ROLL.len()).1,
    sit_up_from_side: &[],
    rise: &T1_RISE,
    turn_from_front: &ROLL,
    turn_from_back: &[],
    rolled_onto_back: 0,
};
/// Those of the K1, which differ on the side, where a K1 stays, and from the squat to the stand.
pub(super) const K1: GetUpFrames = GetUpFrames { sit_up_from_side: &SQUAT_FROM_SIDE, rise: &K1_RISE, ..T1 };

/// From lying on the front to lying on the back.
const ROLL: [GetUpFrame; 3] = [
    GetUpFrame::new(25, [0, 0, -125, -82, 64, -10, 0, 0, -11, -103, 0, 0, 0, -1, 89, 0, 0, 0, 27, 67, 103, 20, 0]),
    GetUpFrame::new(24, [0, 0, 9, 19, 97, -127, 0, 0, -4, 64, 11, 0, 0, 1, 5, 19, 0, 0, -57, 99, -34, 38, 0]),
    GetUpFrame::new(23, [0, 0, 69, -44, 19, 0, 0, 0, -5, 10, 55, 0, 0, 6, -17, 60, 0, 0, -41, 75, -4, 11, 0]),
];

/// From lying on the front, over the back, to a squat on the spread feet.
const SQUAT_FROM_FRONT: [GetUpFrame; 7] = [
    ROLL[0],
    ROLL[1],
    ROLL[2],
    GetUpFrame::symmetric(42, [56, -62, 114, -127], [-1, -11, -2, 47, -6, -4]),
    GetUpFrame::symmetric(40, [69, -96, 53, -84], [-2, -7, -103, 0, -23, 4]),
    GetUpFrame::symmetric(43, [65, -96, -21, 0], [-30, 75, -103, 127, -45, -11]),
    GetUpFrame::symmetric(44, [41, -94, -12, -9], [-57, 58, -68, 127, -12, -23]),
];

/// From lying on the right side, over the back, to the same squat.
const SQUAT_FROM_SIDE: [GetUpFrame; 6] = [
    GetUpFrame::new(
        35,
        [0, 0, -13, -127, 10, -27, 0, -27, 29, -93, 127, 57, 0, -30, -112, 4, 0, 0, 17, 127, -90, 83, 0],
    ),
    GetUpFrame::new(
        35,
        [0, 0, -31, -127, -22, 50, 0, -73, 16, -113, 126, 11, 0, -78, -114, 78, 0, 0, -4, 127, -75, 37, 0],
    ),
    SQUAT_FROM_FRONT[3],
    SQUAT_FROM_FRONT[4],
    SQUAT_FROM_FRONT[5],
    SQUAT_FROM_FRONT[6],
];

/// From the squat of a T1 to half the way to its stand.
const T1_RISE: [GetUpFrame; 2] = [
    GetUpFrame::symmetric(24, [-40, -84, 25, -4], [-29, 44, -86, 127, -37, -23]),
    GetUpFrame::symmetric(32, [-49, -76, -18, 0], [-19, 7, -59, 108, -44, -19]),
];

/// From the squat of a K1 to half the way to its stand.
const K1_RISE: [GetUpFrame; 2] = [
    GetUpFrame::symmetric(31, [-22, -100, 22, -10], [-26, 30, -80, 127, -42, -27]),
    GetUpFrame::symmetric(36, [-48, -71, 2, -2], [0, 25, -62, 109, -35, -19]),
];
