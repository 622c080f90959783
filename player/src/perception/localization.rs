//! Self-localization on the field.

use bica::prelude::*;
use bica::visual::{self, Point2, PoseWithCovariance2};
use bica_field::{FIELD, FieldDimensions};
use bica_motion::pose::Pose2;
use bica_vision::localization::{Estimate, Localizer, MotionNoise, SightingUse, Sightings};
use glam::Vec2;

use super::ego_motion::EgoMotion;
use super::{CameraPose, FieldLines, GoalDetector, Odometry};
use crate::input::CameraInput;
use crate::shapes;

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
        motion: &Tuned<MotionNoise>,
        sightings: &Tuned<SightingUse>,
        time: &Time,
        input: &CameraInput,
        goals: &GoalDetector,
        lines: &FieldLines,
        pose: &CameraPose,
        odometry: &Odometry,
    ) {
        self.localizer.set_tuning(motion, sightings);
        let is_new = self.ego_motion.begin_run(time, odometry, input, |motion, _| self.localizer.advance(motion));
        let Some(camera) = pose.camera().filter(|_| is_new) else { return };
        self.localizer.see(Sightings::of(lines.markings(), goals.goals(), goals.attacked(), camera));
    }

    /// Forgets the pose: people have carried the robot.
    pub const fn forget(&mut self) {
        self.localizer = Localizer::new(SEED);
    }

    /// Counts a cycle since the last run and the last image.
    pub(super) const fn pass_cycle(&mut self) {
        self.ego_motion.pass_cycle();
    }

    /// The most probable pose, reliable or not; `None` before the first sighting, or if the motion of the robot is not known.
    #[must_use]
    pub const fn estimate(&self) -> Option<Estimate> {
        if self.ego_motion.is_fresh() { self.localizer.estimate() } else { None }
    }

    /// Most probable pose on the field, reliable or not, with its covariance: x towards the attacked goal, from the centre.
    #[output(frame = "field")]
    fn robot_pose(&self) -> Option<PoseWithCovariance2> {
        self.estimate().map(|estimate| shapes::pose_with_covariance(estimate.pose, &estimate.covariance))
    }

    /// Most probable pose of the odometry's frame on the field.
    #[output(frame = "field", child = "odometry")]
    fn odometry_origin(&self) -> Option<visual::Pose2> {
        self.estimate().map(|estimate| shapes::pose(estimate.pose * self.ego_motion.pose().inverse()))
    }

    /// Whether most particles agree on the pose.
    #[output]
    fn is_sure(&self) -> bool {
        self.pose().is_some()
    }

    /// Share of the particles near the pose, 0 to 1; 0 before the first sighting.
    #[output]
    fn agreement(&self) -> f32 {
        self.estimate().map_or(0.0, |estimate| estimate.belief)
    }

    /// Left and right post of the attacked goal by the pose.
    #[output(unit = "m", frame = "robot")]
    fn post_positions(&self) -> Option<[Point2; 2]> {
        self.posts().map(|posts| posts.map(shapes::point))
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

    /// The field.
    #[must_use]
    pub const fn field(&self) -> &'static FieldDimensions {
        &FIELD
    }
}
