//! What every world does.

use core::time::Duration;

use bica_motion::robot::{Command, Sensors};

use crate::referee::Referee;

/// The robot's control cycle.
pub const CYCLE: Duration = Duration::from_millis(10);

/// The robot's control cycle, s.
pub const CYCLE_SECONDS: f32 = 0.01;

/// Images come every third of ten cycles: 30 in a second.
const FRAMES_PER_TEN_CYCLES: u64 = 3;

/// The number of the newest image in a cycle.
pub(crate) const fn frame(cycle: u64) -> u64 {
    cycle * FRAMES_PER_TEN_CYCLES / 10
}

/// Whether a camera takes an image in a cycle.
pub(crate) const fn image_is_due(cycle: u64) -> bool {
    cycle == 0 || frame(cycle) != frame(cycle - 1)
}

/// A robot in its surroundings: real, simulated or recorded.
///
/// The loop is: read [`sensors`](Self::sensors), think, [`act`](Self::act). The world stands still in between.
pub trait World {
    /// Time since the start.
    fn now(&self) -> Duration;

    /// What the robot senses now. Asking twice in a cycle gives the same answer.
    ///
    /// The image is there only in the cycles in which a camera brought a new one.
    fn sensors(&mut self) -> Sensors<'_>;

    /// Obeys a command for one control cycle ([`CYCLE`]).
    fn act(&mut self, command: &Command);

    /// Who knows the truth. Nothing of it may reach the player.
    fn referee(&self) -> &Referee;
}
