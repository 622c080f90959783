//! Self-localization on the field.

use bica::prelude::*;
use bica_field::FIELD;
use bica_motion::pose::Pose2;
use bica_vision::localization::{Estimate, Localizer, Sightings};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{CameraPose, FieldLines, GoalDetector, Odometry};
use crate::input::CameraInput;

/// Number of particles.
const PARTICLES: usize = 200;
/// Seed of the filter's random numbers.
const SEED: u64 = 2009;

/// The robot's pose on the field: a particle filter over lines, their crossings, the centre circle and both goals.
///
/// Lines are searched in the image only while this component is active.
pub struct Localization {
    localizer: Localizer<PARTICLES>,
    ego_motion: EgoMotion,
}

#[component(hz = 30, budget_us = 1000)]
impl Localization {
    /// Creates the component with an unknown pose.
    #[must_use]
    pub const fn new() -> Self {
        Self { localizer: Localizer::new(SEED), ego_motion: EgoMotion::new() }
    }

    fn step(
        &mut self,
        input: &CameraInput,
        goals: &GoalDetector,
        lines: &FieldLines,
        pose: &CameraPose,
        odometry: &Odometry,
    ) {
        let is_new = self.ego_motion.begin_run(odometry, input, |motion| self.localizer.advance(motion));
        let Some(camera) = pose.camera().filter(|_| is_new) else { return };
        self.localizer.see(Sightings::of(lines.markings(), goals.goals(), goals.attacked(), camera));
    }

    /// The most probable pose, reliable or not; `None` before the first sighting.
    #[must_use]
    pub const fn estimate(&self) -> Option<Estimate> {
        self.localizer.estimate()
    }

    /// The pose of the point on the ground between the feet in the field frame, x towards the attacked goal; `None` while it
    /// is uncertain.
    #[must_use]
    pub fn pose(&self) -> Option<Pose2> {
        self.estimate().filter(Estimate::is_sure).map(|estimate| estimate.pose)
    }

    /// The left and the right post of the attacked goal, m, in the ground frame between the feet; `None` while the pose is
    /// uncertain.
    #[must_use]
    pub fn posts(&self) -> Option<[Vec2; 2]> {
        let pose = self.pose()?;
        Some(FIELD.goal_posts(true).map(|post| pose.locate(post)))
    }
}
