//! Shared by the perception components: new images, ages of estimates, and the robot's motion between two runs.

use bica::{Instant, Time};
use bica_motion::pose::Pose2;

use super::Odometry;
use crate::roles::Views;

/// Number of cycles up to which an estimate counts, half a second at 100 Hz: some missed images or runs do not matter, and the robot
/// walks 0.1 m at most.
const MAX_AGE: u8 = 50;

/// Age of an estimate. A component that is held latent, whose rate is 0, or that gets no images cannot age its own estimates, so the
/// robot's `sense` counts the cycles (`perception::pass_cycle`), and what readers get is `None` if the estimate is old.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Age(u8);

impl Age {
    /// Age of what was never estimated.
    pub(crate) const fn new() -> Self {
        Self(u8::MAX)
    }

    /// Counts a cycle.
    pub(crate) const fn pass_cycle(&mut self) {
        self.0 = self.0.saturating_add(1);
    }

    /// Notes that the estimate is up to date.
    pub(crate) const fn renew(&mut self) {
        self.0 = 0;
    }

    /// Whether the estimate is of this cycle.
    pub(crate) const fn is_new(self) -> bool {
        self.0 == 0
    }

    /// Whether a reader may use the estimate.
    pub(crate) const fn is_fresh(self) -> bool {
        self.0 <= MAX_AGE
    }
}

/// The newest image that a component has processed.
#[derive(Debug)]
pub(crate) struct LastImage {
    count: u32,
    pub(crate) age: Age,
}

impl LastImage {
    /// Creates a value without an image.
    pub(crate) const fn new() -> Self {
        Self { count: 0, age: Age::new() }
    }

    /// Whether there is an image that the component has not processed; marks it as processed. An image whose memory is
    /// taken counts as processed.
    pub(crate) fn take_new(&mut self, input: &impl Views) -> bool {
        let is_new = self.count != input.count() && input.has_image();
        self.count = input.count();
        if is_new {
            self.age.renew();
        }
        is_new
    }
}

/// Motion of the robot between two runs of a component that remembers positions relative to the robot.
#[derive(Debug)]
pub(crate) struct EgoMotion {
    /// The robot's pose at the last run, in the frame of the odometry.
    pose: Pose2,
    /// Time of the last run.
    at: Option<Instant>,
    age: Age,
    image: LastImage,
}

impl EgoMotion {
    /// Creates a value at the origin of the odometry, for the first run.
    pub(crate) const fn new() -> Self {
        Self { pose: Pose2::ORIGIN, at: None, age: Age::new(), image: LastImage::new() }
    }

    /// Counts a cycle.
    pub(crate) const fn pass_cycle(&mut self) {
        self.age.pass_cycle();
        self.image.age.pass_cycle();
    }

    /// Brings the remembered positions up to date.
    pub(crate) const fn renew(&mut self) {
        self.age.renew();
    }

    /// Begins a run: applies the robot's motion to the remembered positions, and returns whether there is a new image.
    ///
    /// `remembered` is called with the robot's new pose in the frame of its pose at the last run, and the time since then, s, in
    /// which the component may have been latent. Without odometry the time is infinite: positions relative to a robot that may
    /// have walked must be forgotten.
    pub(crate) fn begin_run(
        &mut self,
        time: &Time,
        odometry: &Odometry,
        input: &impl Views,
        remembered: impl FnOnce(Pose2, f32),
    ) -> bool {
        let (motion, seconds) = self.motion(time, odometry);
        remembered(motion, seconds);
        self.image.take_new(input)
    }

    #[inline(never)]
    fn motion(&mut self, time: &Time, odometry: &Odometry) -> (Pose2, f32) {
        let motion = self.pose.inverse() * odometry.pose();
        self.pose = odometry.pose();
        let since_run = time.now.saturating_duration_since(self.at.replace(time.now).unwrap_or(time.now));
        if !odometry.is_fresh() {
            return (motion, f32::INFINITY);
        }
        self.age.renew();
        (motion, Time { since_run, ..*time }.dt())
    }

    /// Whether the remembered positions are those relative to the robot's present pose.
    pub(crate) const fn is_fresh(&self) -> bool {
        self.age.is_fresh()
    }

    /// Whether the newest image was processed a short time ago.
    pub(crate) const fn has_image(&self) -> bool {
        self.image.age.is_fresh()
    }

    /// The pose at the last run, in the frame of the odometry.
    pub(crate) const fn pose(&self) -> Pose2 {
        self.pose
    }
}
