//! The end of a run: the firmware gets the robot back.

use std::time::Duration;

use bica_motion::joints::Joints;

use crate::driver::{Driver, Gait, REST};
use crate::follow::BEFORE_CHANGE;
use crate::phase::{Ending, Phase};
use crate::rpc::Mode;

/// Longest time in which the robot program ends its motion, and time for which the targets rest if it has.
const LONGEST_HALT: Duration = Duration::from_millis(1_200);
const STILL: Duration = Duration::from_millis(300);
/// Largest motion of a target that counts as rest, rad.
const STILL_ANGLE: f32 = 0.02;
/// Longest time for the firmware to take over, from the request to end; then the motors are asked to damp.
const LONGEST_HOLD: Duration = Duration::from_millis(3_500);
/// Longest time from the request to end until the end.
const LONGEST_END: Duration = Duration::from_secs(5);

impl Driver {
    /// Begins the end on request.
    pub(crate) fn begin_end(&mut self, now: Duration) {
        self.stopped = Some(now);
        let is_silent = self.silence(now) > REST;
        match self.phase {
            Phase::Over => {}
            // Nothing was sent yet, or somebody else has the robot.
            Phase::Waiting(_) | Phase::Left => self.finish("the program ends; the robot is as it was"),
            Phase::Following | Phase::Guarding if self.gait == Gait::Firmware => {
                self.say("the program ends: the robot stops, and the firmware holds it");
                let request = self.firmware.stop(now, &mut self.modes);
                self.out.requests.extend(request);
                self.ends_with(Ending::Halt(None));
            }
            Phase::Following if !is_silent && !self.lies() => {
                self.say("the program ends: the robot stops, and the firmware holds it");
                self.ends_with(Ending::Halt(None));
            }
            Phase::Guarding => {
                self.say("the program was killed: its guard gives the robot to the firmware");
                self.ends_with(Ending::Release);
            }
            _ => self.ends_with(Ending::Release),
        }
    }

    /// The next step of the end.
    pub(crate) fn end(&mut self, now: Duration, ending: Ending) {
        let since = self.stopped.map_or(Duration::ZERO, |stopped| now.saturating_sub(stopped));
        if since >= LONGEST_END {
            self.stay_limp(now);
            self.finish("the robot does not answer: hold it, and switch it off");
            self.is_given_back = false;
            return;
        }
        match ending {
            Ending::Halt(still) if self.gait == Gait::Firmware => self.halt_firmware(since, still),
            Ending::Halt(still) => self.halt(now, since, still),
            Ending::Release => self.release(now),
            Ending::Hold => self.hold(now, since),
            Ending::Damp => self.end_damped(now),
        }
    }

    fn halt_firmware(&mut self, since: Duration, still: Option<(Joints, Duration)>) {
        self.phase = Phase::Ending(if since >= STILL { Ending::Release } else { Ending::Halt(still) });
    }

    /// The robot program ends its step and stands.
    fn halt(&mut self, now: Duration, since: Duration, still: Option<(Joints, Duration)>) {
        self.follow(now);
        if !matches!(self.phase, Phase::Ending(_)) {
            // The robot has left the mode, or is silent.
            return self.ends_with(Ending::Release);
        }
        let targets = self.limiter.targets(&self.measured());
        let moves =
            |from: &Joints| self.body.motors.iter().any(|&joint| (from[joint] - targets[joint]).abs() > STILL_ANGLE);
        let still = still.filter(|(from, _)| !moves(from)).unwrap_or((targets, now));
        let rests = now.saturating_sub(still.1) >= STILL;
        let is_done = rests || since >= LONGEST_HALT || self.lies();
        self.phase = Phase::Ending(if is_done { Ending::Release } else { Ending::Halt(Some(still)) });
    }

    /// The gains go before the mode does: they are not allowed in another one.
    fn release(&mut self, now: Duration) {
        if self.has_gains() || self.limp_since.is_some_and(|since| now.saturating_sub(since) < BEFORE_CHANGE) {
            return self.stay_limp(now);
        }
        let can_stand = self.silence(now) <= REST && !self.lies();
        self.ends_with(if can_stand { Ending::Hold } else { Ending::Damp });
    }

    fn hold(&mut self, now: Duration, since: Duration) {
        self.stay_limp(now);
        if self.modes.known(now) == Some(Mode::Prepare) {
            return self.finish("the firmware holds the robot");
        }
        self.want(now, Mode::Prepare);
        if self.modes.refused.is_some() || since >= LONGEST_HOLD {
            self.ends_with(Ending::Damp);
        }
    }

    fn end_damped(&mut self, now: Duration) {
        self.stay_limp(now);
        if self.modes.known(now) == Some(Mode::Damping) {
            return self.finish("the motors damp");
        }
        self.want(now, Mode::Damping);
    }

    fn finish(&mut self, text: &str) {
        self.say(text);
        self.is_given_back = true;
        self.phase = Phase::Over;
    }
}
