//! The joint commands.

use bica::prelude::*;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::limbs::Limbs;
use bica_motion::model::RobotModel;
use bica_motion::stiffness::Stiffness;

use crate::MODEL;

/// Targets and stiffness of all joints.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct JointCommand {
    /// Target angles, rad, within the joint limits.
    pub targets: Joints,
    /// Stiffness, 0 (limp) to 1.
    pub stiffness: Joints,
}

/// Targets and stiffness of all joints, as requested by the motion components and as commanded to the motors.
///
/// A joint that no component writes keeps its last target. Values that are not finite are ignored.
#[derive(Debug)]
pub struct Motors {
    model: &'static RobotModel,
    targets: Joints,
    stiffness: Joints,
    commanded: JointCommand,
}

#[component(budget_us = 1, writers = first)]
impl Motors {
    /// Creates the component with all joints without stiffness until the first targets are written.
    #[must_use]
    pub const fn new() -> Self {
        const ZERO: Joints = Joints([0.0; JOINTS]);
        Self {
            model: MODEL,
            targets: ZERO,
            stiffness: ZERO,
            commanded: JointCommand { targets: ZERO, stiffness: ZERO },
        }
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.model = model;
    }

    /// Sets the targets of the head, rad, and the stiffness of both joints, 0 to 1.
    pub fn set_head(&mut self, pan: f32, tilt: f32, stiffness: f32) {
        self.set(Joint::HeadYaw, pan, stiffness);
        self.set(Joint::HeadPitch, tilt, stiffness);
    }

    /// Sets the targets of arms and legs, rad, with the stiffness for walking.
    pub fn set_limbs(&mut self, limbs: &Limbs) {
        let (targets, stiffness) = (limbs.joints(self.model), Stiffness::Walk.joints(self.model));
        for joint in Joint::ALL {
            if !matches!(joint, Joint::HeadYaw | Joint::HeadPitch) {
                self.set(joint, targets[joint], stiffness[joint]);
            }
        }
    }

    /// Sets the targets of all joints, rad, and one stiffness for all, 0 to 1.
    pub fn set_all(&mut self, targets: &Joints, stiffness: f32) {
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

    /// The requested targets, in the order of the joints.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn targets(&self) -> &Joints {
        &self.targets
    }

    /// The requested stiffness, 0 to 1, in the order of the joints.
    #[output]
    #[must_use]
    pub const fn stiffness(&self) -> &Joints {
        &self.stiffness
    }

    /// Computes the command from the targets, within the joint limits, and this stiffness, 0 to 1.
    pub fn command(&mut self, stiffness: Joints) -> &JointCommand {
        self.commanded = JointCommand { targets: self.targets.clamp_to_limits(self.model), stiffness };
        &self.commanded
    }

    /// The command of the previous cycle, within the joint limits and with the stiffness of hot motors reduced; all zero
    /// before the first one.
    #[output]
    #[must_use]
    pub const fn commanded(&self) -> &JointCommand {
        &self.commanded
    }
}
