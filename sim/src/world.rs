//! The interface of a world, and the timing of its cycles and images.

use core::time::Duration;

pub use bica_body::{CYCLE, CYCLE_SECONDS};
use bica_core::action::Actions;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Command, Sensors};
use glam::Vec2;

use crate::referee::Referee;
use crate::shared_image::SharedImage;

/// Camera images in ten control cycles: 30 per second.
const FRAMES_PER_TEN_CYCLES: u64 = 3;

/// Largest sum of the pushes of a cycle, m/s: above the 2.3 m/s that make each robot fall.
const MAX_PUSH: f32 = 2.5;

/// Sum of the pushes of a cycle, m/s, field frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pushes(Vec2);

impl Pushes {
    /// Adds a push; returns the part that the limit allows, or zero for values that are not finite.
    pub(crate) fn add(&mut self, push: Vec2) -> Vec2 {
        let before = self.0;
        if push.is_finite() {
            self.0 = (before + push).clamp_length_max(MAX_PUSH);
        }
        self.0 - before
    }
}

/// Returns the index of the newest image in a cycle.
pub(crate) const fn frame(cycle: u64) -> u64 {
    cycle * FRAMES_PER_TEN_CYCLES / 10
}

/// Returns whether a camera takes an image in a cycle.
pub(crate) const fn image_is_due(cycle: u64) -> bool {
    cycle == 0 || frame(cycle) != frame(cycle - 1)
}

/// A robot and its surroundings: real, simulated or recorded.
///
/// One control cycle is: read [`sensors`](Self::sensors), compute a command, [`act`](Self::act). Time advances only in
/// `act`. The trait is object-safe: `Box<dyn World>` selects the simulator at run time.
pub trait World {
    /// Time since the start of the world; a multiple of [`CYCLE`].
    fn now(&self) -> Duration;

    /// Measurements of the current cycle. Repeated calls within a cycle return equal values.
    ///
    /// `image` is `Some` only in cycles in which a camera delivers a new image.
    fn sensors(&mut self) -> Sensors<'_>;

    /// Executes a command for one control cycle ([`CYCLE`]).
    fn act(&mut self, command: &Command);

    /// Actions that an operator can request between two cycles.
    fn actions(&mut self) -> &mut dyn Actions;

    /// Puts the ball at a position on the field, m, field frame, at rest, as a person does between two cycles. This
    /// cancels a pending return into play. A placement is not an event: it is never a goal, an out or a touch. Images
    /// that were read earlier in this cycle do not show it.
    ///
    /// # Errors
    ///
    /// If the position is beyond the lines of the field, for example in a goal, or if a post or a robot is there. The
    /// error is a text. The ball then stays where it is.
    fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str>;

    /// Puts the robot on its feet at a pose, field frame, at rest, as a person does between two cycles. It is not an event.
    ///
    /// # Errors
    ///
    /// If the position is beyond the lines of the field, or if a post, another robot or the ball is there. The error is
    /// a text. The robot then stays where it is.
    fn put_robot(&mut self, at: Pose2) -> Result<(), &'static str>;

    /// Pushes the robot: adds `velocity`, m/s, field frame, to the velocity of its torso. The pushes of one cycle, for
    /// example while a run is paused, add up to at most 2.5 m/s. Values that are not finite are ignored.
    fn add_velocity(&mut self, velocity: Vec2);

    /// Reason why the world cannot continue; a run ends then. `None` if it can continue, always in the kinematic world.
    fn failure(&self) -> Option<&str> {
        None
    }

    /// Access to the pixels of the newest image without a copy. The default has no image.
    fn shared_image(&self) -> SharedImage {
        SharedImage::default()
    }

    /// Ground truth and events, for evaluation only. The robot's program must not read it.
    fn referee(&self) -> &Referee;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pushes_of_a_cycle_have_a_limit() {
        let mut pushes = Pushes::default();
        let all = (0..20).map(|_| pushes.add(Vec2::X * 0.8)).sum::<Vec2>();
        assert!(all.distance(Vec2::X * MAX_PUSH) < 1e-5, "{all}");
        assert_eq!(pushes.add(Vec2::new(f32::NAN, 0.0)), Vec2::ZERO);
        assert!(pushes.add(-Vec2::X).distance(-Vec2::X) < 1e-5, "a push back");
    }

    #[test]
    fn thirty_of_hundred_cycles_have_new_image() {
        let cycles: Vec<u64> = (0..100).filter(|cycle| image_is_due(*cycle)).collect();
        assert_eq!(cycles.len(), 30);
        assert_eq!(cycles[..4], [0, 4, 7, 10]);
    }

    #[test]
    fn image_index_changes_with_next_image() {
        for cycle in 1..1_000 {
            let expected = frame(cycle - 1) + u64::from(image_is_due(cycle));
            assert_eq!(frame(cycle), expected, "cycle {cycle}");
        }
    }
}
