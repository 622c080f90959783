//! What the joints are told.

use bica::prelude::*;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::limbs::Limbs;
use bica_motion::model::Nao;
use bica_motion::stiffness::Stiffness;

/// How stiff the head is held (B-Human 2023).
const HEAD: f32 = 0.7;

/// Targets and stiffness of all joints.
///
/// The head and the rest of the body have writers of their own; what nobody writes keeps its last target.
#[derive(Debug)]
pub struct Motors {
    targets: Joints,
    stiffness: Joints,
}

#[component(budget_us = 1)]
impl Motors {
    /// Limp until a first target comes.
    #[must_use]
    pub const fn new() -> Self {
        Self { targets: Joints([0.0; JOINTS]), stiffness: Joints([0.0; JOINTS]) }
    }

    /// Sets the head's targets, rad. What is no number is not done.
    pub fn head(&mut self, pan: f32, tilt: f32) {
        self.set(Joint::HeadYaw, pan, HEAD);
        self.set(Joint::HeadPitch, tilt, HEAD);
    }

    /// Sets the targets of arms and legs for walking, rad. What is no number is not done.
    pub fn limbs(&mut self, limbs: &Limbs) {
        self.all_but_head(&limbs.joints(), &Stiffness::Walk.joints::<Nao>());
    }

    /// Sets the targets of all joints but the head's, rad, and how stiff they hold them. What is no number is not done.
    pub fn all_but_head(&mut self, targets: &Joints, stiffness: &Joints) {
        for joint in Joint::ALL {
            if !matches!(joint, Joint::HeadYaw | Joint::HeadPitch) {
                self.set(joint, targets[joint], stiffness[joint]);
            }
        }
    }

    /// Sets the targets of all joints, rad, and one stiffness for all, 0 to 1. What is no number is not done.
    pub fn whole(&mut self, targets: &Joints, stiffness: f32) {
        for joint in Joint::ALL {
            self.set(joint, targets[joint], stiffness);
        }
    }

    fn set(&mut self, joint: Joint, target: f32, stiffness: f32) {
        if target.is_finite() && stiffness.is_finite() {
            self.targets[joint] = target;
            self.stiffness[joint] = stiffness.clamp(0.0, 1.0);
        }
    }

    /// The targets, rad, within the joints' limits.
    #[must_use]
    pub fn targets(&self) -> Joints {
        self.targets.clamp_to_limits::<Nao>()
    }

    /// The stiffness, 0 to 1.
    #[must_use]
    pub const fn stiffness(&self) -> &Joints {
        &self.stiffness
    }
}
