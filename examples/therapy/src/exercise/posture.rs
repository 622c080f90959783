//! Directions of trunk and upper arms.

use bica_motion::side::Side;
use glam::Vec3;

use crate::skeleton::{Point, Skeleton};

/// Directions that the check of an exercise takes from one skeleton.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Posture {
    /// Direction of the trunk upwards, in the frame of the camera, unit length.
    pub(crate) trunk: Vec3,
    /// Directions of the left and the right upper arm, unit length. Frame of the body: x from the right to the left
    /// shoulder, y up along the trunk, z at right angles to both.
    pub(crate) arms: [Option<Vec3>; 2],
}

/// The trunk and one arm of a posture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) trunk: Vec3,
    pub(crate) arm: Vec3,
}

/// Points of the trunk. Averages of several points are less noisy.
const UPPER: [Point; 2] = [Point::Chest, Point::Neck];
const LOWER: [Point; 3] = [Point::Waist, Point::LeftHip, Point::RightHip];
const SHOULDERS: [Point; 2] = [Point::LeftShoulder, Point::RightShoulder];

impl Posture {
    /// Computes the directions from the points with at least this confidence, 0 to 1; `None` if the trunk is not seen.
    pub(crate) fn of(skeleton: Option<&Skeleton>, confidence: f32) -> Option<Self> {
        let skeleton = skeleton?;
        let sure = |points: &[Point]| skeleton.is_sure(points, confidence);
        if !(sure(&UPPER) && sure(&LOWER) && sure(&SHOULDERS)) {
            return None;
        }
        let middle =
            |points: &[Point]| points.iter().map(|&point| skeleton.at(point)).sum::<Vec3>() / points.len() as f32;
        let [left, right] = SHOULDERS.map(|point| skeleton.at(point));
        let trunk = (middle(&UPPER) - middle(&LOWER)).try_normalize()?;
        let lateral = (left - right).reject_from(trunk).try_normalize()?;
        let forward = lateral.cross(trunk);
        let arm = |shoulder: Vec3, elbow: Point| {
            let arm = (skeleton.at(elbow) - shoulder).try_normalize().filter(|_| sure(&[elbow]))?;
            Some(Vec3::new(arm.dot(lateral), arm.dot(trunk), arm.dot(forward)))
        };
        Some(Self { trunk, arms: [arm(left, Point::LeftElbow), arm(right, Point::RightElbow)] })
    }

    /// Returns the trunk and one arm; `None` if this arm is not seen.
    pub(crate) fn side(&self, side: Side) -> Option<Seen> {
        Some(Seen { trunk: self.trunk, arm: self.arms[side.index()]? })
    }
}
