//! The place on the field.

use bica::prelude::*;
use bica_field::FIELD;
use bica_motion::pose::Pose2;
use bica_vision::localization::{Estimate, Localizer, Sightings};
use glam::Vec2;

use super::ride::Ride;
use super::{CameraPose, FieldLines, NetDetector, Odometry};
use crate::input::Eye;

/// Poses that are thought possible at a time.
const PARTICLES: usize = 200;
/// What the filter draws its random numbers from.
const SEED: u64 = 2009;

/// Where the robot is on the field: by lines, their crossings, the centre circle and both goals.
///
/// Only while it is active the lines are looked for.
pub struct Localization {
    localizer: Localizer<PARTICLES>,
    ride: Ride,
}

#[component(hz = 30, budget_us = 1000)]
impl Localization {
    /// Knows nothing.
    #[must_use]
    pub const fn new() -> Self {
        Self { localizer: Localizer::new(SEED), ride: Ride::new() }
    }

    fn step(&mut self, eye: &Eye, net: &NetDetector, lines: &FieldLines, pose: &CameraPose, odometry: &Odometry) {
        self.localizer.advance(self.ride.motion(odometry));
        if !self.ride.sees_anew(eye) {
            return;
        }
        if let Some(camera) = pose.camera() {
            self.localizer.see(Sightings::of(lines.markings(), net.goals(), net.attacked(), camera));
        }
    }

    /// What is believed most, sure or not; none before anything was seen.
    #[must_use]
    pub const fn estimate(&self) -> Option<Estimate> {
        self.localizer.estimate()
    }

    /// Where the ground between the feet is in the field, x towards the attacked goal, if that is sure.
    #[must_use]
    pub fn pose(&self) -> Option<Pose2> {
        self.estimate().filter(Estimate::is_sure).map(|estimate| estimate.pose)
    }

    /// Where the left and the right post of the attacked goal are, m, in the frame on the ground between the feet; if the
    /// robot is sure where it is itself.
    #[must_use]
    pub fn posts(&self) -> Option<[Vec2; 2]> {
        let pose = self.pose()?;
        Some(FIELD.goal_posts(true).map(|post| pose.locate(post)))
    }
}
