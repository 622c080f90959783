//! A kick under way.

use super::Kick;
use super::frames::{STAND, STRIKE};
use super::pose::KickPose;
use crate::limbs::Limbs;
use crate::walk::Parameters;
use crate::walk::shape::smooth;

/// A kick under way: [`step`](Self::step) it once per control cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickMotion {
    kick: Kick,
    index: usize,
    time: f32,
    from: KickPose,
}

impl KickMotion {
    /// A kick that begins now; the robot stands as [`Parameters::stand`] says.
    #[must_use]
    pub const fn new(kick: Kick) -> Self {
        Self { kick, index: 0, time: 0.0, from: STAND }
    }

    /// Which kick it is.
    #[must_use]
    pub const fn kick(&self) -> Kick {
        self.kick
    }

    /// Whether it is over and the robot told to stand.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.index >= self.kick.frames().len()
    }

    /// Whether the foot strikes now: the ball moves from here on.
    #[must_use]
    pub const fn strikes(&self) -> bool {
        self.index == STRIKE
    }

    /// `dt` seconds later: the targets for legs and arms; the stand when done.
    pub fn step(&mut self, dt: f32) -> Limbs {
        if dt > 0.0 {
            self.time += dt;
        }
        let frames = self.kick.frames();
        while let Some(&(seconds, pose)) = frames.get(self.index).filter(|frame| self.time >= frame.0) {
            self.time -= seconds;
            self.from = pose;
            self.index += 1;
        }
        let stand = Parameters::BUILT_IN.stand();
        let Some((seconds, to)) = frames.get(self.index) else { return stand };
        let pose = self.from.mix(to, smooth(self.time / seconds));
        Limbs { legs: pose.legs(self.kick.foot), ..stand }
    }
}
