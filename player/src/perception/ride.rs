//! How what is remembered rides along with the robot, from image to image.

use bica_motion::pose::Pose2;

use super::Odometry;
use crate::input::Eye;

/// Where the robot was at a component's last run, and the image that it saw last.
#[derive(Debug)]
pub(super) struct Ride {
    pose: Pose2,
    image: u32,
}

impl Ride {
    /// From where the robot starts, before the first image.
    pub(super) const fn new() -> Self {
        Self { pose: Pose2::ORIGIN, image: 0 }
    }

    /// How the robot moved since the last run: its new pose, seen from its old one.
    #[inline(never)]
    pub(super) fn motion(&mut self, odometry: &Odometry) -> Pose2 {
        let motion = self.pose.inverse() * odometry.pose();
        self.pose = odometry.pose();
        motion
    }

    /// Whether the eye has another image than at the last run.
    pub(super) const fn sees_anew(&mut self, eye: &Eye) -> bool {
        let is_new = self.image != eye.count();
        self.image = eye.count();
        is_new
    }

    /// The heading of the last run, rad, in the frame of the odometry.
    pub(super) const fn heading(&self) -> f32 {
        self.pose.heading
    }
}
