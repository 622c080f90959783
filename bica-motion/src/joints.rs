//! Joints of a humanoid robot, and one value for each.
//!
//! Order and names follow the NAO V6's own interface (`LoLA`). A robot with fewer joints lists its joints in
//! [`RobotModel::joints`](crate::model::RobotModel::joints). A robot without fingers may have a waist and a second hip yaw in
//! their places ([`Joint::WAIST_YAW`], [`Joint::RIGHT_HIP_YAW`]): messages keep their size. Angles are in radians; hands range
//! from 0 (closed) to 1 (open).

use core::ops::{Index, IndexMut};

/// Number of joints in the vocabulary, both hands included.
pub const JOINTS: usize = 25;

/// A joint of a humanoid.
///
/// `LHipYawPitch` is the one motor that both legs share; there is no right one.
#[expect(missing_docs, reason = "the names are those of the robot's interface and need no explanation")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, postcard_schema::Schema)]
#[repr(u8)]
pub enum Joint {
    HeadYaw,
    HeadPitch,
    LShoulderPitch,
    LShoulderRoll,
    LElbowYaw,
    LElbowRoll,
    LWristYaw,
    LHipYawPitch,
    LHipRoll,
    LHipPitch,
    LKneePitch,
    LAnklePitch,
    LAnkleRoll,
    RHipRoll,
    RHipPitch,
    RKneePitch,
    RAnklePitch,
    RAnkleRoll,
    RShoulderPitch,
    RShoulderRoll,
    RElbowYaw,
    RElbowRoll,
    RWristYaw,
    LHand,
    RHand,
}

impl Joint {
    /// Yaw of the torso over the hips, in the place of [`LHand`](Self::LHand).
    pub const WAIST_YAW: Self = Self::LHand;
    /// Left hip yaw of a robot with two, in the place of [`LHipYawPitch`](Self::LHipYawPitch).
    pub const LEFT_HIP_YAW: Self = Self::LHipYawPitch;
    /// Right hip yaw of a robot with two, in the place of [`RHand`](Self::RHand).
    pub const RIGHT_HIP_YAW: Self = Self::RHand;

    /// Every joint, in order.
    pub const ALL: [Self; JOINTS] = [
        Self::HeadYaw,
        Self::HeadPitch,
        Self::LShoulderPitch,
        Self::LShoulderRoll,
        Self::LElbowYaw,
        Self::LElbowRoll,
        Self::LWristYaw,
        Self::LHipYawPitch,
        Self::LHipRoll,
        Self::LHipPitch,
        Self::LKneePitch,
        Self::LAnklePitch,
        Self::LAnkleRoll,
        Self::RHipRoll,
        Self::RHipPitch,
        Self::RKneePitch,
        Self::RAnklePitch,
        Self::RAnkleRoll,
        Self::RShoulderPitch,
        Self::RShoulderRoll,
        Self::RElbowYaw,
        Self::RElbowRoll,
        Self::RWristYaw,
        Self::LHand,
        Self::RHand,
    ];

    /// Position of the joint in [`ALL`](Self::ALL), 0 to 24.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// One value for every joint, indexed by [`Joint`].
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Joints<T = f32>(pub [T; JOINTS]);

impl<T: Copy> Joints<T> {
    /// The same value for every joint.
    #[must_use]
    pub const fn all(value: T) -> Self {
        Self([value; JOINTS])
    }
}

impl<T: Copy + Default> Default for Joints<T> {
    fn default() -> Self {
        Self::all(T::default())
    }
}

impl<T> Index<Joint> for Joints<T> {
    type Output = T;

    fn index(&self, joint: Joint) -> &T {
        &self.0[joint.index()]
    }
}

impl<T> IndexMut<Joint> for Joints<T> {
    fn index_mut(&mut self, joint: Joint) -> &mut T {
        &mut self.0[joint.index()]
    }
}
