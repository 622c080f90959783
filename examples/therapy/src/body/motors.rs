//! The joint commands.

use core::ops::RangeInclusive;

use bica::prelude::*;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::NAO;

/// Posture at rest: the stand, with the arms down.
pub(crate) const REST: Joints = NAO.stand;

/// Indices of the joints of the legs.
const LEGS: RangeInclusive<usize> = Joint::LHipYawPitch.index()..=Joint::RAnkleRoll.index();
/// Stiffness of arms and head.
const ARMS: f32 = 0.6;

/// Targets and stiffness of all joints.
#[derive(Debug)]
pub struct Motors {
    targets: Joints,
    /// Stiffness of the legs.
    legs: f32,
    soft: bool,
}

#[component(budget_us = 1, writers = first)]
impl Motors {
    pub(crate) const fn new() -> Self {
        Self { targets: REST, legs: 0.75, soft: false }
    }

    /// Sets the targets of arms and head, rad.
    pub(crate) fn set(&mut self, targets: &Joints) {
        self.write(targets, false);
    }

    /// Sets the targets of the legs, rad, and their stiffness, 0 to 1.
    pub(crate) fn set_legs(&mut self, targets: &Joints, stiffness: f32) {
        self.write(targets, true);
        self.legs = stiffness;
    }

    fn write(&mut self, targets: &Joints, legs: bool) {
        let targets = targets.clamp_to_limits(NAO);
        for joint in (0..JOINTS).filter(|joint| LEGS.contains(joint) == legs) {
            self.targets.0[joint] = targets.0[joint];
        }
    }

    /// Returns whether the targets of arms and head are those at rest, within 0.03 rad.
    pub(crate) fn arms_rest(&self) -> bool {
        (0..JOINTS).all(|joint| LEGS.contains(&joint) || libm::fabsf(self.targets.0[joint] - REST.0[joint]) < 0.03)
    }

    /// Makes arms and head limp or stiff.
    pub(crate) const fn soften(&mut self, soft: bool) {
        self.soft = soft;
    }

    /// Targets, in the order of the joints.
    #[output(unit = "rad")]
    pub(crate) const fn targets(&self) -> &Joints {
        &self.targets
    }

    /// Stiffness of each joint, 0 to 1.
    pub(crate) fn stiffness(&self) -> Joints {
        let arms = if self.soft { 0.0 } else { ARMS };
        Joints(core::array::from_fn::<_, JOINTS, _>(|joint| if LEGS.contains(&joint) { self.legs } else { arms }))
    }
}
