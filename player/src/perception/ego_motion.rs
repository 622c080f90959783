//! Shared by the perception components: detection of new images, and the robot's motion between them.

use bica_motion::pose::Pose2;

use super::Odometry;
use crate::input::CameraInput;

/// The newest image that a component has processed.
#[derive(Debug)]
pub(super) struct LastImage(u32);

impl LastImage {
    /// Creates a value without an image.
    pub(super) const fn new() -> Self {
        Self(0)
    }

    /// Whether there is an image that the component has not processed; marks it as processed. An image whose memory is
    /// taken counts as processed.
    pub(super) const fn take_new(&mut self, input: &CameraInput) -> bool {
        let is_new = self.0 != input.count() && input.has_image();
        self.0 = input.count();
        is_new
    }
}

/// Motion of the robot between two runs of a component that remembers positions relative to the robot.
#[derive(Debug)]
pub(super) struct EgoMotion {
    /// The robot's pose at the last run, in the frame of the odometry.
    pose: Pose2,
    image: LastImage,
}

impl EgoMotion {
    /// Creates a value at the origin of the odometry, for the first run.
    pub(super) const fn new() -> Self {
        Self { pose: Pose2::ORIGIN, image: LastImage::new() }
    }

    /// Begins a run: applies the robot's motion to the remembered positions, and returns whether there is a new image.
    ///
    /// `remembered` is called with the robot's new pose in the frame of its pose at the last run.
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

    /// The pose at the last run, in the frame of the odometry.
    pub(super) const fn pose(&self) -> Pose2 {
        self.pose
    }
}
