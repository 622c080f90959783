//! Joint commands, and what takes them away.

use std::time::Duration;

use bica_motion::joints::Joint;

use crate::CYCLE;
use crate::driver::{Driver, Gait, REST, SILENT, Turn};
use crate::firmware::{Motion, Standing};
use crate::message::LowCmd;
use crate::phase::{Phase, Waiting};
use crate::rpc::Mode;
use crate::start::HEARD_AGAIN;

/// Joints that the firmware's gait moves on request.
const HEAD: [Joint; 2] = [Joint::HeadYaw, Joint::HeadPitch];
/// Least time between two commands: an answer that is early waits, so that no target moves faster than the limiter allows.
const SOONEST: Duration = Duration::from_millis(8);
/// Time after which the last targets are sent again if the robot program is late.
const LATE: Duration = Duration::from_millis(20);
/// Time for which commands without gains follow those with gains.
const LIMP: Duration = Duration::from_secs(1);
/// Time between commands without gains and the request of another mode, which must not arrive first.
pub(crate) const BEFORE_CHANGE: Duration = Duration::from_millis(30);

impl Driver {
    /// Takes the gains away until an operator starts the program again.
    pub(crate) fn leave(&mut self) {
        self.say("the robot is in another mode: the program commands nothing until it is started again");
        self.phase = Phase::Left;
    }

    /// Whether joint commands may be sent; goes to another phase if not.
    pub(crate) fn may_command(&mut self, now: Duration) -> bool {
        match self.modes.known(now) {
            Some(Mode::Custom) if self.silence(now) <= SILENT => return true,
            Some(Mode::Custom) => self.begin_damping(),
            Some(_) => self.leave(),
            None => {
                self.say("the robot does not tell its mode: no gains until it does");
                self.phase = Phase::Unknown;
            }
        }
        self.stay_limp(now);
        false
    }

    pub(crate) fn follow(&mut self, now: Duration) {
        if !self.may_command(now) {
            return;
        }
        if self.silence(now) > REST {
            if self.since_sent(now) >= CYCLE {
                self.rest(now);
            }
            return;
        }
        let is_fresh = self.turn == Turn::Fresh;
        if self.since_sent(now) >= if is_fresh { SOONEST } else { LATE } {
            self.counts.late += u64::from(!is_fresh);
            self.command(now);
        }
        self.offer(now);
    }

    /// Offers the robot program a cycle if it is time to.
    pub(crate) fn offer(&mut self, now: Duration) {
        if self.turn == Turn::Offered || now < self.due {
            return;
        }
        let Some(mut sensors) = self.sensors else { return };
        let since = self.offered.map_or(CYCLE, |offered| now.saturating_sub(offered));
        if self.gait == Gait::Firmware {
            // The firmware's legs do not follow the targets of this program, whose monitor of joints would call them stuck, and whose
            // odometry would measure them: it gets the body that follows its own walk, with the head of the robot.
            for &joint in self.body.motors.iter().filter(|joint| !HEAD.contains(joint)) {
                sensors.angles[joint] = self.last.targets[joint];
            }
        }
        // A cycle that begins late does not delay those after it, except by a whole cycle or more.
        self.due = CYCLE + if now < self.due + CYCLE { self.due } else { now };
        let (roll, pitch) = (sensors.inertial.roll, sensors.inertial.pitch);
        self.estimator.complete(&mut sensors, since.min(10 * CYCLE).as_secs_f32());
        // The robot's own estimate is better than that of this filter, which serves the forces on the soles.
        (sensors.inertial.roll, sensors.inertial.pitch) = (roll, pitch);
        (self.offered, self.turn) = (Some(now), Turn::Offered);
        self.counts.cycles += 1;
        self.out.cycle = Some(sensors);
    }

    pub(crate) fn since_sent(&self, now: Duration) -> Duration {
        self.sent.map_or(Duration::MAX, |sent| now.saturating_sub(sent))
    }

    /// Sends the last targets.
    pub(crate) fn command(&mut self, now: Duration) {
        let seconds = self.since_sent(now).min(Duration::from_secs(1)).as_secs_f32();
        let (targets, stiffness) = (self.last.targets, self.last.stiffness);
        let command = self.limiter.command(&targets, &stiffness, &self.measured(), seconds);
        self.put(now, command);
        if self.turn == Turn::Fresh {
            self.turn = Turn::Sent;
        }
    }

    /// Sends targets that do not move.
    fn rest(&mut self, now: Duration) {
        let command = self.limiter.command(&self.last.targets, &self.last.stiffness, &self.measured(), 0.0);
        self.put(now, command);
    }

    fn put(&mut self, now: Duration, command: LowCmd) {
        (self.has_gains, self.limp_since, self.sent) = (true, None, Some(now));
        self.out.command = Some(command);
    }

    /// Takes the gains away if there are any, and says so to the robot for a while.
    pub(crate) fn stay_limp(&mut self, now: Duration) {
        if core::mem::take(&mut self.has_gains) {
            self.limp_since = Some(now);
        }
        let is_told = self.limp_since.is_none_or(|since| now.saturating_sub(since) >= LIMP);
        if is_told || (self.limp_since != Some(now) && self.since_sent(now) < CYCLE) {
            return;
        }
        self.sent = Some(now);
        self.out.command = Some(self.limiter.limp(&self.measured()));
    }

    pub(crate) fn find_mode(&mut self, now: Duration) {
        self.stay_limp(now);
        match self.modes.known(now) {
            Some(Mode::Custom) if self.silence(now) <= REST => self.start(now),
            Some(Mode::Custom) | None => {}
            Some(_) => self.leave(),
        }
    }

    pub(crate) fn begin_damping(&mut self) {
        self.say("the robot has sent nothing for 0.5 s: damping");
        self.phase = Phase::Damping;
    }

    pub(crate) fn damp(&mut self, now: Duration) {
        self.stay_limp(now);
        if self.limp_since.is_none_or(|since| now.saturating_sub(since) >= BEFORE_CHANGE) {
            self.want(now, Mode::Damping);
        }
        if self.modes.known(now) == Some(Mode::Damping) {
            self.phase = Phase::Waiting(Waiting { needed: HEARD_AGAIN, since: None });
        }
    }

    pub(crate) fn follow_firmware(&mut self, now: Duration) {
        if self.silence(now) > SILENT {
            return self.begin_damping();
        }
        let mode = self.modes.known(now);
        match self.firmware.standing(now, mode) {
            Standing::Walks => {
                let motion = if self.silence(now) > REST { Motion::default() } else { self.motion };
                let requests = self.firmware.go(now, &mut self.modes, &motion, self.body);
                self.out.requests.extend(requests);
            }
            Standing::Lies => {
                let request = self.firmware.get_up(now, &mut self.modes);
                self.out.requests.extend(request);
            }
            Standing::IsUp => self.want(now, Mode::Walking),
            Standing::Left => return self.leave(),
        }
        if self.silence(now) <= REST {
            self.offer(now);
        }
    }
}
