//! Playback of a kick.

use super::{Kick, technique};
use crate::easing::smooth;
use crate::limbs::{LegAngles, Limbs};
use crate::model::{KickFrame, KickPose, Profile, RobotModel, Technique};
use crate::side::Side;
use crate::walk::{Balance, Feedback};

/// Duration of the motion from the last pose to the stand, s.
const END: f32 = 0.35;
/// Height of the kicking foot from which the other foot bears all weight, m.
const LIFTED: f32 = 0.015;

/// A kick in progress: call [`step`](Self::step) once per control cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickMotion {
    kick: Kick,
    profile: &'static Profile,
    index: usize,
    time: f32,
    from: KickPose,
    balance: Balance,
    model: &'static RobotModel,
}

impl KickMotion {
    /// A kick that begins now; the robot is in the [`stand`](crate::walk::Parameters::stand) of its gait.
    #[must_use]
    pub const fn new(model: &'static RobotModel, kick: Kick, profile: &'static Profile) -> Self {
        let from = KickPose::stand(&profile.gait);
        Self { kick, profile, index: 0, time: 0.0, from, balance: Balance::new(), model }
    }

    /// The kick.
    #[must_use]
    pub const fn kick(&self) -> Kick {
        self.kick
    }

    /// Duration from stand to stand, s.
    #[must_use]
    pub fn seconds(&self) -> f32 {
        self.frames().iter().map(|frame| frame.duration).sum::<f32>() + END
    }

    /// Whether the motion has ended; then the targets are the stand.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.index > self.frames().len()
    }

    /// Whether the foot moves through the ball's position now.
    #[must_use]
    pub const fn strikes(&self) -> bool {
        self.index == Technique::STRIKE
    }

    /// Advances by `dt` seconds; returns the targets of legs and arms; the stand when done.
    pub fn step(&mut self, feedback: &Feedback, dt: f32) -> Limbs {
        let gait = &self.profile.gait;
        self.balance.update(self.model, feedback, gait, 0.0);
        if dt > 0.0 {
            self.time += dt;
        }
        while let Some(KickFrame { duration, pose }) = self.frame().filter(|frame| self.time >= frame.duration) {
            self.time -= duration;
            self.from = pose;
            self.index += 1;
        }
        let stand = gait.stand(self.model);
        let Some(KickFrame { duration, pose: to }) = self.frame() else { return stand };
        let pose = self.from.mix(&to, smooth(self.time / duration));
        let mut legs = pose.legs(self.model, self.kick.foot, gait);
        self.stabilise(&mut legs, smooth(pose.foot.z / LIFTED));
        Limbs { legs, ..stand }
    }

    /// Adds the balance of the support leg. `share`: share of its full load, 0 to 1.
    fn stabilise(&self, legs: &mut [LegAngles; 2], share: f32) {
        let support: Side = self.kick.foot.other();
        let [pitch, roll] = self.balance.standing(&self.profile.gait, 1.0);
        let leg = &mut legs[support.index()];
        leg.ankle_pitch += pitch;
        leg.ankle_roll += roll;
        leg.hip_roll += share * support.sign() * self.profile.gait.kick_hip_roll_offset;
    }

    const fn frames(&self) -> &'static [KickFrame] {
        technique(&self.profile.kicks, self.kick.kind).frames
    }

    fn frame(&self) -> Option<KickFrame> {
        let frames = self.frames();
        let stand = || KickFrame { duration: END, pose: KickPose::stand(&self.profile.gait) };
        let end = (self.index == frames.len()).then(stand);
        frames.get(self.index).copied().or(end)
    }
}
