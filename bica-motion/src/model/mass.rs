//! Masses of a robot's segments.

use glam::Vec3;

use crate::segment::{SEGMENTS, Segment};
use crate::side::Side;

/// Mass and centre of mass of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// Mass, kg.
    pub mass: f32,
    /// Centre of mass, m, in the frame of the joint that moves the segment.
    pub centre: Vec3,
}

impl Mass {
    /// A mass from grams and millimetres.
    #[must_use]
    pub const fn grams(mass: f32, x: f32, y: f32, z: f32) -> Self {
        Self { mass: mass * 1e-3, centre: Vec3::new(x * 1e-3, y * 1e-3, z * 1e-3) }
    }

    const fn on(self, side: Side) -> Self {
        Self { mass: self.mass, centre: Vec3::new(self.centre.x, side.sign() * self.centre.y, self.centre.z) }
    }
}

/// Masses of all segments, in the order of [`Segment::ALL`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Masses {
    segments: [Mass; SEGMENTS],
    total: f32,
}

impl Masses {
    /// Masses of a symmetric body, from the trunk and the left side.
    ///
    /// `trunk`: torso, neck, head. `arm`: shoulder, biceps, elbow, forearm, hand. `leg`: pelvis, hip, thigh, tibia, ankle, foot.
    #[must_use]
    pub const fn symmetric(trunk: [Mass; 3], arm: [Mass; 5], leg: [Mass; 6]) -> Self {
        let (mut segments, mut total) = ([trunk[0]; SEGMENTS], 0.0);
        let mut i = 0;
        while i < SEGMENTS {
            segments[i] = match Segment::ALL[i] {
                Segment::Torso => trunk[0],
                Segment::Neck => trunk[1],
                Segment::Head => trunk[2],
                Segment::Shoulder(side) => arm[0].on(side),
                Segment::Biceps(side) => arm[1].on(side),
                Segment::Elbow(side) => arm[2].on(side),
                Segment::Forearm(side) => arm[3].on(side),
                Segment::Hand(side) => arm[4].on(side),
                Segment::Pelvis(side) => leg[0].on(side),
                Segment::Hip(side) => leg[1].on(side),
                Segment::Thigh(side) => leg[2].on(side),
                Segment::Tibia(side) => leg[3].on(side),
                Segment::Ankle(side) => leg[4].on(side),
                Segment::Foot(side) => leg[5].on(side),
            };
            total += segments[i].mass;
            i += 1;
        }
        Self { segments, total }
    }

    /// Mass of a segment.
    #[must_use]
    pub const fn of(&self, segment: Segment) -> Mass {
        self.segments[segment.index()]
    }

    /// Mass of the whole robot, kg.
    #[must_use]
    pub const fn total(&self) -> f32 {
        self.total
    }
}
