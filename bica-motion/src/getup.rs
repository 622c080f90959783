//! Getting up.
//!
//! Two fixed movements of our own after the pattern that rUNSWift 2019 and HULKs 2025 use: from the front, spread legs and
//! push with the arms until the feet are under the body; from the back, sit up and pull the feet in. Both pass the same
//! phases at their end, by which a world without forces may honour them: a *tuck* (both knees bent beyond
//! [`TUCKED_KNEE`]), then [`STAND`], held for [`HOLD`] seconds.

use crate::fall::Direction;
use crate::keyframes::Keyframe;
use crate::stand::{SIT, STAND, symmetric};

/// In the tuck both knees are bent further than this, rad.
pub const TUCKED_KNEE: f32 = 1.8;
/// How long the stand at the end is held as part of the movement, s.
pub const HOLD: f32 = 0.8;

const fn frame(seconds: f32, stiffness: f32, head_pitch: f32, arm: [f32; 5], leg: [f32; 6]) -> Keyframe {
    Keyframe { seconds, posture: symmetric(head_pitch, arm, leg), stiffness }
}

/// From lying on the front: 4.4 s.
pub const FROM_FRONT: [Keyframe; 7] = [
    // Straight legs, arms out to the sides.
    frame(0.5, 0.7, 0.0, [60.0, 60.0, 0.0, -30.0, 0.0], [0.0, 0.0, 0.0, 5.0, 0.0, 0.0]),
    // Hands beside the shoulders, toes to the ground.
    frame(0.5, 0.9, -30.0, [-10.0, 40.0, -60.0, -80.0, 0.0], [0.0, 0.0, 0.0, 10.0, -40.0, 0.0]),
    // Legs spread wide, hands push.
    frame(0.6, 1.0, -20.0, [20.0, 20.0, -60.0, -40.0, 0.0], [-60.0, 30.0, -40.0, 60.0, -40.0, 0.0]),
    // The hips come up and back over the feet.
    frame(0.6, 1.0, 10.0, [40.0, 10.0, -60.0, -10.0, 0.0], [-60.0, 20.0, -60.0, 100.0, -60.0, 0.0]),
    // The tuck.
    Keyframe { seconds: 0.6, posture: SIT, stiffness: 1.0 },
    Keyframe { seconds: 0.8, posture: STAND, stiffness: 1.0 },
    Keyframe { seconds: HOLD, posture: STAND, stiffness: 0.8 },
];

/// From lying on the back: 4.4 s.
pub const FROM_BACK: [Keyframe; 7] = [
    // Straight legs, arms behind the back.
    frame(0.5, 0.7, 0.0, [115.0, 30.0, 0.0, -20.0, 0.0], [0.0, 0.0, 0.0, 5.0, 0.0, 0.0]),
    // Hands to the ground, chin to the chest, legs drawn up.
    frame(0.5, 0.9, 25.0, [119.0, 15.0, 60.0, -60.0, 0.0], [0.0, 0.0, -80.0, 90.0, -10.0, 0.0]),
    // It sits up.
    frame(0.6, 1.0, 25.0, [110.0, 15.0, 60.0, -10.0, 0.0], [-40.0, 10.0, -88.0, 100.0, -20.0, 0.0]),
    // The feet come under the body.
    frame(0.6, 1.0, 20.0, [100.0, 15.0, 0.0, -10.0, 0.0], [-50.0, 20.0, -75.0, 118.0, -60.0, 0.0]),
    // The tuck.
    Keyframe { seconds: 0.6, posture: SIT, stiffness: 1.0 },
    Keyframe { seconds: 0.8, posture: STAND, stiffness: 1.0 },
    Keyframe { seconds: HOLD, posture: STAND, stiffness: 0.8 },
];

/// The movement that gets a robot up from where it lies. From a side it is the one from the back: the drawn-up legs roll
/// the body over.
#[must_use]
pub const fn from(lying: Direction) -> &'static [Keyframe] {
    match lying {
        Direction::Front => &FROM_FRONT,
        Direction::Back | Direction::Left | Direction::Right => &FROM_BACK,
    }
}

/// The movement to try after so many `failures`: every other time the one for the other side, in case the robot lies
/// otherwise than it feels.
#[must_use]
pub const fn attempt(lying: Direction, failures: u8) -> &'static [Keyframe] {
    match lying {
        _ if failures.is_multiple_of(2) => from(lying),
        Direction::Front => &FROM_BACK,
        Direction::Back | Direction::Left | Direction::Right => &FROM_FRONT,
    }
}

/// The posture in which to fall, for arms and legs: drawn in, the head away from the ground; with little stiffness
/// ([`Stiffness::Fall`](crate::stand::Stiffness::Fall)). Angles after HULKs 2025 (knees 110°, head −33° and +25°).
#[must_use]
pub const fn protection(falling: Direction) -> Keyframe {
    let head = match falling {
        Direction::Front => -33.0,
        Direction::Back | Direction::Left | Direction::Right => 25.0,
    };
    frame(0.4, 0.3, head, [90.0, 20.0, 0.0, -45.0, 0.0], [0.0, 0.0, -50.0, 110.0, -60.0, 0.0])
}
