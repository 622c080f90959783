//! Skeleton of the person in front of the robot.

use bica::prelude::*;

use crate::skeleton::Skeleton;

/// The newest skeleton of the person, and the number of skeletons so far.
#[derive(Debug)]
pub struct PatientPose {
    pub(crate) skeleton: Option<Skeleton>,
    pub(crate) number: u32,
}

#[component]
impl PatientPose {
    pub(crate) const fn new() -> Self {
        Self { skeleton: None, number: 0 }
    }

    /// Stores a new skeleton.
    pub(crate) const fn see(&mut self, skeleton: Skeleton) {
        self.skeleton = Some(skeleton);
        self.number = self.number.wrapping_add(1);
    }
}
