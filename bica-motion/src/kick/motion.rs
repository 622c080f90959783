//! A kick under way.

use super::Kick;
use super::pose::{Frame, KickPose};
use super::technique::STRIKE;
use crate::easing::smooth;
use crate::limbs::Limbs;
use crate::profile::Profile;
use crate::side::Side;
use crate::walk::{Balance, Feedback};

/// The way back to the stand after the last pose, s.
const END: f32 = 0.35;
/// With the foot this high the other one carries everything, m.
const LIFTED: f32 = 0.015;

/// A kick under way: [`step`](Self::step) it once per control cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickMotion {
    kick: Kick,
    profile: &'static Profile,
    index: usize,
    time: f32,
    from: KickPose,
    balance: Balance,
}

impl KickMotion {
    /// A kick that begins now; the robot stands as the [`stand`](crate::walk::Parameters::stand) of its gait.
    #[must_use]
    pub const fn new(kick: Kick, profile: &'static Profile) -> Self {
        let from = KickPose::stand(&profile.gait);
        Self { kick, profile, index: 0, time: 0.0, from, balance: Balance::new() }
    }

    /// Which kick it is.
    #[must_use]
    pub const fn kick(&self) -> Kick {
        self.kick
    }

    /// From stand to stand, s.
    #[must_use]
    pub fn seconds(&self) -> f32 {
        self.frames().iter().map(|frame| frame.0).sum::<f32>() + END
    }

    /// Whether it is over and the robot told to stand.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.index > self.frames().len()
    }

    /// Whether the foot strikes now: the ball moves from here on.
    #[must_use]
    pub const fn strikes(&self) -> bool {
        self.index == STRIKE
    }

    /// `dt` seconds later: the targets for legs and arms; the stand when done.
    pub fn step(&mut self, body: &Feedback, dt: f32) -> Limbs {
        let gait = &self.profile.gait;
        self.balance.feel(body, gait);
        if dt > 0.0 {
            self.time += dt;
        }
        while let Some((seconds, pose)) = self.frame().filter(|frame| self.time >= frame.0) {
            self.time -= seconds;
            self.from = pose;
            self.index += 1;
        }
        let stand = gait.stand();
        let Some((seconds, to)) = self.frame() else { return stand };
        let pose = self.from.mix(&to, smooth(self.time / seconds));
        let mut legs = pose.legs(self.kick.foot, gait);
        self.steady(&mut legs, smooth(pose.foot.z / LIFTED));
        Limbs { legs, ..stand }
    }

    /// Steadies the foot that carries this `share` of what it carries alone.
    fn steady(&self, legs: &mut [crate::kinematics::LegAngles; 2], share: f32) {
        let standing: Side = self.kick.foot.other();
        let [pitch, roll] = self.balance.standing(&self.profile.gait);
        let leg = &mut legs[standing.index()];
        leg.ankle_pitch += pitch;
        leg.ankle_roll += roll;
        leg.hip_roll += share * standing.sign() * self.profile.gait.kick_hip_roll_offset;
    }

    const fn frames(&self) -> &'static [Frame] {
        self.profile.kicks.of(self.kick.kind).frames
    }

    fn frame(&self) -> Option<Frame> {
        let frames = self.frames();
        let end = (self.index == frames.len()).then(|| (END, KickPose::stand(&self.profile.gait)));
        frames.get(self.index).copied().or(end)
    }
}
