//! The joint commands.

use bica::prelude::*;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::{Nao, RobotModel};

/// Posture at rest: the stand, with the arms down.
pub const REST: Joints = Nao::STAND;

/// Stiffness of the legs, which stand, and of arms and head.
const LEGS: f32 = 0.75;
const ARMS: f32 = 0.6;

/// Targets and stiffness of all joints. The legs stand.
#[derive(Debug)]
pub struct Motors {
    targets: Joints,
    soft: bool,
}

#[component(budget_us = 1)]
impl Motors {
    /// Creates the component at rest.
    #[must_use]
    pub const fn new() -> Self {
        Self { targets: REST, soft: false }
    }

    /// Sets the targets, rad.
    pub fn set(&mut self, targets: &Joints) {
        self.targets = targets.clamp_to_limits::<Nao>();
    }

    /// Makes arms and head soft or stiff.
    pub const fn soften(&mut self, soft: bool) {
        self.soft = soft;
    }

    /// Targets, in the order of the joints.
    #[info(unit = "rad")]
    #[must_use]
    pub const fn targets(&self) -> &Joints {
        &self.targets
    }

    /// Stiffness of each joint, 0 to 1.
    #[must_use]
    pub fn stiffness(&self) -> Joints {
        let legs = Joint::LHipYawPitch.index()..=Joint::RAnkleRoll.index();
        let arms = if self.soft { 0.0 } else { ARMS };
        Joints(core::array::from_fn::<_, JOINTS, _>(|joint| if legs.contains(&joint) { LEGS } else { arms }))
    }
}
