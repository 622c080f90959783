//! What the perception components share: new images, and the robot's motion between them.

use bica_motion::pose::Pose2;

use super::Odometry;
use crate::input::CameraInput;

/// The newest image that a component has processed.
#[derive(Debug)]
pub(super) struct LastImage(u32);

impl LastImage {
    /// No image yet.
    pub(super) const fn new() -> Self {
        Self(0)
    }

    /// Whether there is an image that the component has not processed; from then on it counts as processed.
    pub(super) const fn take_new(&mut self, input: &CameraInput) -> bool {
        let is_new = self.0 != input.count();
        self.0 = input.count();
        is_new
    }
}

/// The robot's motion between two runs of a component that remembers places relative to the robot.
#[derive(Debug)]
pub(super) struct EgoMotion {
    /// The robot's pose at the last run, in the frame of the odometry.
    pose: Pose2,
    image: LastImage,
}

impl EgoMotion {
    /// Before the first run: at the origin of the odometry.
    pub(super) const fn new() -> Self {
        Self { pose: Pose2::ORIGIN, image: LastImage::new() }
    }

    /// Begins a run: moves what the component remembers along with the robot, and returns whether there is a new image.
    ///
    /// `remembered` gets the robot's new pose in the frame of its pose at the last run.
    pub(super) fn begin_run(
        &mut self,
        odometry: &Odometry,
        input: &CameraInput,
        remembered: impl FnOnce(Pose2),
    ) -> bool {
        remembered(self.motion(odometry));
        self.image.take_new(input)
    }

    #[inline(never)]
    fn motion(&mut self, odometry: &Odometry) -> Pose2 {
        let motion = self.pose.inverse() * odometry.pose();
        self.pose = odometry.pose();
        motion
    }

    /// The heading at the last run, rad, in the frame of the odometry.
    pub(super) const fn heading(&self) -> f32 {
        self.pose.heading
    }
}
