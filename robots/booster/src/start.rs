//! The way to a robot that follows: prepare, custom, the stand.

use std::time::Duration;

use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::Command;

use crate::CYCLE;
use crate::driver::{Driver, Gait, REST, SILENT};
use crate::phase::{Phase, Preparing, Transition, Waiting};
use crate::rpc::Mode;

/// Time without a gap in the states before the robot is touched: at the start, and after it was silent.
pub(crate) const HEARD: Duration = Duration::from_millis(200);
pub(crate) const HEARD_AGAIN: Duration = Duration::from_secs(2);
/// Time for which the firmware holds a robot that stands still, before joint commands.
const PREPARED: Duration = Duration::from_secs(1);
const STILL: Duration = Duration::from_millis(300);
/// Largest motion of a joint that counts as still, rad.
const STILL_ANGLE: f32 = 0.05;
/// Largest angle of the shoulders' pitch at the start, rad: 40°. Source: B-Human's release of 2025.
const MAX_SHOULDER_PITCH: f32 = 0.698;
/// Duration of the motion to the stand, s.
const RISE_SECONDS: f32 = 2.0;

impl Driver {
    pub(crate) fn wait(&mut self, now: Duration, waiting: Waiting) {
        self.stay_limp(now);
        let since = if self.silence(now) < REST { waiting.since.or(Some(now)) } else { None };
        let is_heard = since.is_some_and(|since| now.saturating_sub(since) >= waiting.needed);
        self.phase = if is_heard {
            self.say("the robot is there: prepare is requested, and it stands up");
            Phase::Preparing(Preparing::default())
        } else {
            Phase::Waiting(Waiting { since, ..waiting })
        };
    }

    pub(crate) fn prepare(&mut self, now: Duration, mut preparing: Preparing) {
        self.stay_limp(now);
        if self.silence(now) > SILENT {
            self.phase = Phase::Waiting(Waiting { needed: HEARD, since: None });
            return;
        }
        let known = self.modes.known(now);
        if preparing.since.is_some() && known.is_some_and(|mode| mode != Mode::Prepare) {
            return self.leave();
        }
        self.want(now, Mode::Prepare);
        let angles = self.measured();
        let moves = |from: &Joints| self.body.motors.iter().any(|&it| (from[it] - angles[it]).abs() > STILL_ANGLE);
        if preparing.still.is_none_or(|(from, _)| moves(&from)) {
            preparing.still = Some((angles, now));
        }
        preparing.since = preparing.since.or(known.map(|_| now).filter(|_| known == Some(Mode::Prepare)));
        let lasts = |since: Option<Duration>, time| since.is_some_and(|since| now.saturating_sub(since) >= time);
        let is_ready = known == Some(Mode::Prepare)
            && lasts(preparing.since, PREPARED)
            && lasts(preparing.still.map(|(_, since)| since), STILL);
        let is_apart = self.gait == Gait::Own && shoulder(&angles) > MAX_SHOULDER_PITCH;
        if is_ready && is_apart && !preparing.has_told {
            preparing.has_told = true;
            self.say("the shoulders' pitch is beyond 40°: move the arms to the body");
        }
        self.phase = if is_ready && !is_apart { Phase::Entering } else { Phase::Preparing(preparing) };
    }

    /// Mode in which the robot follows.
    pub(crate) const fn wanted(&self) -> Mode {
        match self.gait {
            Gait::Own => Mode::Custom,
            Gait::Firmware => Mode::Walking,
        }
    }

    pub(crate) fn want(&mut self, now: Duration, mode: Mode) {
        let request = self.modes.want(now, mode);
        self.out.requests.extend(request);
    }

    pub(crate) fn enter(&mut self, now: Duration) {
        if self.silence(now) > REST {
            self.phase = Phase::Waiting(Waiting { needed: HEARD, since: None });
            return;
        }
        match self.modes.known(now) {
            Some(mode) if mode == self.wanted() => self.start(now),
            Some(mode) if mode != Mode::Prepare => self.leave(),
            _ => self.want(now, self.wanted()),
        }
    }

    pub(crate) fn start(&mut self, now: Duration) {
        self.say("the robot follows the program");
        self.last = Command::new(self.body.model.stand, 1.0);
        let from = self.limiter.targets(&self.measured());
        self.phase = match self.gait {
            Gait::Own if !self.lies() => Phase::Rising(Transition::new(from, self.body.model.stand, now, RISE_SECONDS)),
            _ => Phase::Following,
        };
        if let Phase::Rising(transition) = self.phase {
            self.rise(now, &transition);
        }
    }

    pub(crate) fn rise(&mut self, now: Duration, transition: &Transition) {
        if !self.may_command(now) {
            return;
        }
        if transition.is_done(now) || self.lies() {
            self.phase = Phase::Following;
        }
        if self.silence(now) <= REST {
            (self.last.targets, self.last.stiffness) = (transition.at(now), Joints::all(1.0));
        }
        if self.since_sent(now) >= CYCLE {
            self.command(now);
        }
    }
}

/// Largest pitch of the shoulders, rad.
fn shoulder(angles: &Joints) -> f32 {
    angles[Joint::LShoulderPitch].abs().max(angles[Joint::RShoulderPitch].abs())
}
