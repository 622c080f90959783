//! Outer shape of the body, for the detection of the robot's own body in its camera images.

/// All points within a radius of a line segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// One end of the line, m.
    pub from: [f32; 3],
    /// The other end of the line, m.
    pub to: [f32; 3],
    /// Radius, m.
    pub radius: f32,
}

/// Capsules of the body, each in the frame of its segment (see [`Segment`](crate::segment::Segment)).
///
/// Those of limbs are the left side's; the right side is the mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyShape {
    /// Two capsules of the torso.
    pub torso: [Capsule; 2],
    /// Shoulder and upper arm, on the biceps.
    pub biceps: [Capsule; 2],
    /// Lower arm and hand, on the forearm.
    pub forearm: Capsule,
    /// Thigh.
    pub thigh: Capsule,
    /// Tibia.
    pub tibia: Capsule,
    /// Inner and outer half of the foot.
    pub foot: [Capsule; 2],
}
