//! Skeleton of a person, as measured by a depth camera or by a pose detector in images.

#[cfg(any(feature = "host", test))]
mod person;

use bica::prelude::*;
use glam::Vec3;

#[cfg(any(feature = "host", test))]
pub use person::Person;

/// Number of points of a [`Skeleton`].
pub const POINTS: usize = 10;

/// A point of a person's body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Point {
    /// Middle of the head.
    Head,
    /// Base of the neck.
    Neck,
    /// Middle of the chest at the height of the shoulders.
    Chest,
    /// Middle of the pelvis.
    Waist,
    /// Left shoulder.
    LeftShoulder,
    /// Right shoulder.
    RightShoulder,
    /// Left elbow.
    LeftElbow,
    /// Right elbow.
    RightElbow,
    /// Left hip.
    LeftHip,
    /// Right hip.
    RightHip,
}

/// Points of a body with the confidence in each. Any unit and any frame are allowed: only angles are computed.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skeleton {
    /// Positions, in the order of [`Point`].
    pub points: [[f32; 3]; POINTS],
    /// Confidence in each point, 0 (a guess, or hidden) to 1.
    pub confidence: [f32; POINTS],
}

/// A numbering of the points of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// 22 points of a Kinect, as in UI-PRMD: waist 0, spine 1, chest 2, neck 3, head 4, left arm from 6, right arm from 10, legs from
    /// 14 and 18. Source: Vakanski and others, Data 3:2, 2018.
    Kinect22,
    /// 25 points of a Kinect 2 (`JointType` of its software). Source: Microsoft, Kinect for Windows SDK 2.0.
    Kinect25,
    /// 17 points of COCO. It has neither neck nor waist: the middles of shoulders and hips are used.
    Coco17,
    /// 25 points of `BODY_25`. Source: `OpenPose`, output format.
    Body25,
    /// 33 points of `MediaPipe` Pose, which has neither neck nor waist.
    MediaPipe33,
}

impl Layout {
    /// Number of points, and which of them are averaged for each [`Point`].
    const fn table(self) -> (usize, [&'static [usize]; POINTS]) {
        match self {
            Self::Kinect22 => (22, [&[4], &[3], &[2], &[0], &[7], &[11], &[8], &[12], &[14], &[18]]),
            Self::Kinect25 => (25, [&[3], &[2], &[20], &[0], &[4], &[8], &[5], &[9], &[12], &[16]]),
            Self::Coco17 => (17, [&[3, 4], &[5, 6], &[5, 6], &[11, 12], &[5], &[6], &[7], &[8], &[11], &[12]]),
            Self::Body25 => (25, [&[17, 18], &[1], &[1], &[8], &[5], &[2], &[6], &[3], &[12], &[9]]),
            Self::MediaPipe33 => {
                (33, [&[7, 8], &[11, 12], &[11, 12], &[23, 24], &[11], &[12], &[13], &[14], &[23], &[24]])
            }
        }
    }

    /// Converts points of this layout to a skeleton; `None` if their number differs. A point that is not finite has confidence 0.
    #[must_use]
    pub fn read(self, points: &[Vec3], confidence: &[f32]) -> Option<Skeleton> {
        let (count, sources) = self.table();
        if points.len() != count || confidence.len() != count {
            return None;
        }
        let mean = |of: &[usize]| of.iter().map(|&index| points[index]).sum::<Vec3>() / of.len() as f32;
        let read: [Vec3; POINTS] = core::array::from_fn(|point| mean(sources[point]));
        let sure = |of: &[usize]| of.iter().map(|&index| confidence[index]).fold(1.0, f32::min);
        let confidence =
            core::array::from_fn(|point| if read[point].is_finite() { sure(sources[point]).max(0.0) } else { 0.0 });
        Some(Skeleton { points: read.map(Vec3::into), confidence })
    }
}

impl Skeleton {
    /// Position of a point.
    #[must_use]
    pub const fn at(&self, point: Point) -> Vec3 {
        Vec3::from_array(self.points[point as usize])
    }

    /// Returns whether the confidence in each of the points is at least this value.
    #[must_use]
    pub fn is_sure(&self, points: &[Point], confidence: f32) -> bool {
        points.iter().all(|&point| self.confidence[point as usize] >= confidence)
    }
}

#[cfg(test)]
mod tests {
    use super::Point::{Head, LeftElbow, RightHip, RightShoulder};
    use super::*;

    /// Names of the points of [`Point`] in the sources, by their numbers.
    #[test]
    fn layouts_take_the_points_that_their_sources_number() {
        let named = |layout: Layout, names: [(Point, usize); 4]| {
            let points: [Vec3; 33] = core::array::from_fn(|index| Vec3::splat(index as f32));
            let count = layout.table().0;
            let skeleton = layout.read(&points[..count], &[1.0; 33][..count]).expect("as many points");
            for (point, index) in names {
                assert_eq!(skeleton.at(point).x as usize, index, "{layout:?} {point:?}");
            }
        };
        named(Layout::Kinect25, [(Head, 3), (LeftElbow, 5), (RightShoulder, 8), (RightHip, 16)]);
        named(Layout::Coco17, [(Head, 3), (LeftElbow, 7), (RightShoulder, 6), (RightHip, 12)]);
        named(Layout::Body25, [(Head, 17), (LeftElbow, 6), (RightShoulder, 2), (RightHip, 9)]);
        named(Layout::MediaPipe33, [(Head, 7), (LeftElbow, 13), (RightShoulder, 12), (RightHip, 24)]);
    }

    #[test]
    fn a_middle_is_as_sure_as_its_less_sure_point() {
        let (mut points, mut confidence) = ([Vec3::ONE; 17], [0.9; 17]);
        (confidence[5], points[12]) = (0.2, Vec3::NAN);
        let skeleton = Layout::Coco17.read(&points, &confidence).expect("17 points");
        assert!(!skeleton.is_sure(&[Point::Neck], 0.3) && skeleton.is_sure(&[Point::RightShoulder], 0.9));
        assert!(!skeleton.is_sure(&[Point::Waist], 0.1), "a point is not finite");
        assert_eq!(Layout::Body25.read(&points, &confidence), None);
    }
}
