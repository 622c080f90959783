//! The skeleton of the person before the robot.

use bica::prelude::*;

use crate::skeleton::Skeleton;

/// The newest skeleton of the person.
#[derive(Debug)]
pub struct PatientPose {
    skeleton: Option<Skeleton>,
    number: u32,
}

#[component]
impl PatientPose {
    /// Creates the component before the first skeleton.
    #[must_use]
    pub const fn new() -> Self {
        Self { skeleton: None, number: 0 }
    }

    /// Takes a new skeleton.
    pub const fn see(&mut self, skeleton: Skeleton) {
        self.skeleton = Some(skeleton);
        self.number = self.number.wrapping_add(1);
    }

    /// The newest skeleton.
    #[must_use]
    pub const fn skeleton(&self) -> Option<&Skeleton> {
        self.skeleton.as_ref()
    }

    /// Number of skeletons so far.
    #[info]
    #[must_use]
    pub const fn number(&self) -> u32 {
        self.number
    }
}
