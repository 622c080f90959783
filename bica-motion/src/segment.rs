//! Rigid segments of the body.

use crate::side::Side;

/// Number of segments.
pub const SEGMENTS: usize = 25;

/// A rigid segment of the body. The origin of its frame is the joint that moves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Segment {
    /// Chest and back; its frame is the robot frame.
    Torso,
    /// Moved by the head's yaw.
    Neck,
    /// Moved by the head's pitch; carries the cameras.
    Head,
    /// Moved by the shoulder's pitch.
    Shoulder(Side),
    /// Moved by the shoulder's roll.
    Biceps(Side),
    /// Moved by the elbow's yaw.
    Elbow(Side),
    /// Moved by the elbow's roll.
    Forearm(Side),
    /// Moved by the wrist's yaw.
    Hand(Side),
    /// Moved by the shared hip yaw-pitch.
    Pelvis(Side),
    /// Moved by the hip's roll.
    Hip(Side),
    /// Moved by the hip's pitch.
    Thigh(Side),
    /// Moved by the knee.
    Tibia(Side),
    /// Moved by the ankle's pitch.
    Ankle(Side),
    /// Moved by the ankle's roll; ends in the sole.
    Foot(Side),
}

impl Segment {
    /// Every segment, from the torso outwards, in the order of [`index`](Self::index).
    pub const ALL: [Self; SEGMENTS] = {
        use Side::{Left, Right};
        [
            Self::Torso,
            Self::Neck,
            Self::Head,
            Self::Shoulder(Left),
            Self::Biceps(Left),
            Self::Elbow(Left),
            Self::Forearm(Left),
            Self::Hand(Left),
            Self::Shoulder(Right),
            Self::Biceps(Right),
            Self::Elbow(Right),
            Self::Forearm(Right),
            Self::Hand(Right),
            Self::Pelvis(Left),
            Self::Hip(Left),
            Self::Thigh(Left),
            Self::Tibia(Left),
            Self::Ankle(Left),
            Self::Foot(Left),
            Self::Pelvis(Right),
            Self::Hip(Right),
            Self::Thigh(Right),
            Self::Tibia(Right),
            Self::Ankle(Right),
            Self::Foot(Right),
        ]
    };

    /// Position of the segment in [`ALL`](Self::ALL).
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Torso => 0,
            Self::Neck => 1,
            Self::Head => 2,
            Self::Shoulder(side) => 3 + 5 * side.index(),
            Self::Biceps(side) => 4 + 5 * side.index(),
            Self::Elbow(side) => 5 + 5 * side.index(),
            Self::Forearm(side) => 6 + 5 * side.index(),
            Self::Hand(side) => 7 + 5 * side.index(),
            Self::Pelvis(side) => 13 + 6 * side.index(),
            Self::Hip(side) => 14 + 6 * side.index(),
            Self::Thigh(side) => 15 + 6 * side.index(),
            Self::Tibia(side) => 16 + 6 * side.index(),
            Self::Ankle(side) => 17 + 6 * side.index(),
            Self::Foot(side) => 18 + 6 * side.index(),
        }
    }

    /// Mirror image of the segment; those of trunk and head are their own mirror images.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        match self.index() {
            arm @ 3..8 => Self::ALL[arm + 5],
            arm @ 8..13 => Self::ALL[arm - 5],
            leg @ 13..19 => Self::ALL[leg + 6],
            leg @ 19.. => Self::ALL[leg - 6],
            _ => self,
        }
    }
}
