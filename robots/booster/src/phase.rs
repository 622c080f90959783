//! What the driver does with the robot.

use std::time::Duration;

use bica_motion::joints::Joints;

/// Phase of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Phase {
    /// The program has the robot, and this driver is that of its guard.
    Guarding,
    /// States do not come, or did not for long enough.
    Waiting(Waiting),
    /// The firmware brings the robot to its standing posture; time of the first answer that says so.
    Preparing(Preparing),
    /// Joint commands, or the firmware's gait, are requested.
    Entering,
    /// From the measured posture to the stand.
    Rising(Transition),
    /// The robot program commands.
    Following,
    /// The mode is not known: no gains until it is.
    Unknown,
    /// States did not come: the motors damp.
    Damping,
    /// The robot was taken away, as by its remote control: the program must be started again.
    Left,
    /// The run ends.
    Ending(Ending),
    /// The program may end.
    Over,
}

/// Wait for states without a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Waiting {
    /// Duration without a gap that is needed.
    pub(crate) needed: Duration,
    /// When the newest sequence without a gap began.
    pub(crate) since: Option<Duration>,
}

/// Wait for a robot that stands still.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Preparing {
    /// When the mode was first known.
    pub(crate) since: Option<Duration>,
    /// Posture that it keeps, rad, and since when.
    pub(crate) still: Option<(Joints, Duration)>,
    /// Whether people were told about its shoulders.
    pub(crate) has_told: bool,
}

/// Part of the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ending {
    /// The robot program ends its motion: last targets, rad, and since when they rest.
    Halt(Option<(Joints, Duration)>),
    /// The gains are taken away; then the firmware gets the robot.
    Release,
    /// The firmware is asked to hold the robot.
    Hold,
    /// The motors are asked to damp.
    Damp,
}

/// Motion of all joints from rest to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transition {
    from: Joints,
    to: Joints,
    start: Duration,
    seconds: f32,
}

impl Transition {
    pub(crate) const fn new(from: Joints, to: Joints, start: Duration, seconds: f32) -> Self {
        Self { from, to, start, seconds }
    }

    /// Targets, rad.
    pub(crate) fn at(&self, now: Duration) -> Joints {
        let t = (now.saturating_sub(self.start).as_secs_f32() / self.seconds).min(1.0);
        let share = t * t * (3.0 - 2.0 * t);
        let mut targets = self.from;
        for (target, to) in targets.0.iter_mut().zip(self.to.0) {
            *target += share * (to - *target);
        }
        targets
    }

    pub(crate) fn is_done(&self, now: Duration) -> bool {
        now.saturating_sub(self.start).as_secs_f32() >= self.seconds
    }
}
