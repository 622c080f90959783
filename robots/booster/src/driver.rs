//! The driver as a function of time and messages: what is sent, and when the robot program gets a cycle.

use std::time::Duration;

use bica_motion::joints::Joints;
use bica_motion::robot::{Command, Sensors};
use bica_motion::senses::SenseEstimator;

use crate::CYCLE;
use crate::body::Body;
use crate::firmware::{Firmware, Motion, Standing};
use crate::limiter::Limiter;
use crate::measured::{is_lying, sensors};
use crate::message::{FallDownState, LowCmd, LowState, RpcReqMsg, RpcRespMsg};
use crate::mode::ModeKeeper;
use crate::phase::{Ending, Phase, Preparing, Transition, Waiting};
use crate::rpc::Mode;

/// Time without a state after which the targets rest.
pub(crate) const REST: Duration = Duration::from_millis(50);
/// Time without a state after which the motors damp.
const SILENT: Duration = Duration::from_millis(500);
/// Time without a gap in the states before the robot is touched: at the start, and after it was silent.
const HEARD: Duration = Duration::from_millis(200);
const HEARD_AGAIN: Duration = Duration::from_secs(2);
/// Time for which the firmware holds a robot that stands still, before joint commands.
const PREPARED: Duration = Duration::from_secs(1);
const STILL: Duration = Duration::from_millis(300);
/// Largest motion of a joint that counts as still, rad.
const STILL_ANGLE: f32 = 0.05;
/// Largest angle of the shoulders' pitch at the start, rad: 40°. Source: B-Human's release of 2025.
const MAX_SHOULDER_PITCH: f32 = 0.698;
/// Duration of the motion to the stand, s.
const RISE_SECONDS: f32 = 2.0;
/// Time after which the last targets are sent again if the robot program is late.
const LATE: Duration = Duration::from_millis(20);
/// Time for which commands without gains follow those with gains.
pub(crate) const LIMP: Duration = Duration::from_secs(1);
/// Time between commands without gains and the request of another mode, which must not arrive first.
pub(crate) const BEFORE_CHANGE: Duration = Duration::from_millis(30);
/// Least time between two lines about states that were not used.
const BETWEEN_REJECTIONS: Duration = Duration::from_secs(1);

/// Whose gait walks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gait {
    /// That of the robot program, by joint commands.
    #[default]
    Own,
    /// The maker's, by requests.
    Firmware,
}

/// What has come since the last step.
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<'a> {
    /// States in their order.
    pub states: &'a [LowState],
    /// The newest estimate of a fall.
    pub fall: Option<FallDownState>,
    /// Answers in their order.
    pub answers: &'a [RpcRespMsg],
    /// The robot program's command, and what it requests of the firmware, as the answer to a cycle.
    pub command: Option<(&'a Command, Motion)>,
    /// Whether the program was asked to end.
    pub stop: bool,
}

/// What is sent.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// Command for the motors.
    pub command: Option<LowCmd>,
    /// Requests in their order.
    pub requests: Vec<RpcReqMsg>,
    /// Sensor values of a new cycle of the robot program.
    pub cycle: Option<Sensors<'static>>,
    /// What to tell people.
    pub notes: Vec<String>,
}

/// Driver of a robot. It knows no clock and no network.
pub struct Driver {
    pub(crate) body: &'static Body,
    pub(crate) gait: Gait,
    pub(crate) limiter: Limiter,
    pub(crate) modes: ModeKeeper,
    pub(crate) firmware: Firmware,
    pub(crate) phase: Phase,
    pub(crate) out: Outputs,
    estimator: SenseEstimator,
    pub(crate) sensors: Option<Sensors<'static>>,
    /// Time of the newest state, of the newest line about one that was not used, of the newest cycle and of the newest command.
    heard: Option<Duration>,
    rejected_at: Option<Duration>,
    offered: Option<Duration>,
    sent: Option<Duration>,
    /// When the gains were taken away.
    pub(crate) limp_since: Option<Duration>,
    has_gains: bool,
    pub(crate) is_given_back: bool,
    is_answered: bool,
    pub(crate) last: Command,
    pub(crate) motion: Motion,
    /// When the end was requested.
    pub(crate) stopped: Option<Duration>,
    counts: Counts,
}

/// Numbers of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// States that were used.
    pub states: u64,
    /// States that were not.
    pub rejected: u64,
    /// Cycles of the robot program.
    pub cycles: u64,
    /// Commands that repeat the last targets because the robot program was late.
    pub late: u64,
}

impl Driver {
    /// Driver of a robot that has sent nothing yet. `own` differs from the number of each other client.
    #[must_use]
    pub fn new(body: &'static Body, gait: Gait, own: u64) -> Self {
        Self {
            body,
            gait,
            limiter: Limiter::new(body),
            modes: ModeKeeper::new(own),
            firmware: Firmware::new(),
            phase: Phase::Waiting(Waiting { needed: HEARD, since: None }),
            out: Outputs::default(),
            estimator: SenseEstimator::new(body.model),
            sensors: None,
            heard: None,
            rejected_at: None,
            offered: None,
            sent: None,
            limp_since: None,
            has_gains: false,
            is_given_back: false,
            is_answered: true,
            last: Command::new(body.model.stand, 1.0),
            motion: Motion::default(),
            stopped: None,
            counts: Counts::default(),
        }
    }

    /// Looks at what has come until `now`, the time since the start of the program; returns what to send.
    pub fn step(&mut self, now: Duration, inputs: &Inputs<'_>) -> Outputs {
        self.hear(now, inputs);
        if inputs.stop && self.stopped.is_none() {
            self.begin_end(now);
        }
        match self.phase {
            Phase::Waiting(waiting) => self.wait(now, waiting),
            Phase::Preparing(preparing) => self.prepare(now, preparing),
            Phase::Entering => self.enter(now),
            Phase::Rising(transition) => self.rise(now, &transition),
            Phase::Following if self.gait == Gait::Firmware => self.follow_firmware(now),
            Phase::Following => self.follow(now, inputs.command.is_some()),
            Phase::Unknown => self.find_mode(now),
            Phase::Damping => self.damp(now),
            Phase::Left => self.stay_limp(now),
            Phase::Ending(ending) => self.end(now, ending, inputs.command.is_some()),
            Phase::Over => {}
        }
        if self.heard.is_some() && self.phase != Phase::Over {
            let question = self.modes.ask(now);
            self.out.requests.extend(question);
        }
        core::mem::take(&mut self.out)
    }

    /// Whether the program may end.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.phase == Phase::Over
    }

    /// Whether the program has ended in order: the robot is not left with targets.
    #[must_use]
    pub const fn is_given_back(&self) -> bool {
        self.is_given_back
    }

    /// Whether the end was requested, so that the robot program should end its motion.
    #[must_use]
    pub const fn is_ending(&self) -> bool {
        self.stopped.is_some()
    }

    /// Numbers of the run so far.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    pub(crate) fn say(&mut self, text: impl Into<String>) {
        self.out.notes.push(text.into());
    }

    fn hear(&mut self, now: Duration, inputs: &Inputs<'_>) {
        for state in inputs.states {
            match sensors(self.body, state) {
                Ok(sensors) => {
                    (self.sensors, self.heard) = (Some(sensors), Some(now));
                    self.counts.states += 1;
                }
                Err(mistake) => {
                    self.counts.rejected += 1;
                    if self.rejected_at.is_none_or(|last| now.saturating_sub(last) > BETWEEN_REJECTIONS) {
                        self.rejected_at = Some(now);
                        self.say(format!("a state was not used: {mistake}"));
                    }
                }
            }
        }
        self.firmware.fall = inputs.fall.unwrap_or(self.firmware.fall);
        for answer in inputs.answers {
            let before = self.modes.refused;
            self.modes.take(now, answer);
            if let Some(status) = self.modes.refused.filter(|_| before.is_none()) {
                self.say(format!("the robot refuses the mode: status {status}"));
            }
        }
        if let Some((command, motion)) = inputs.command {
            self.is_answered = true;
            if command.check().is_ok() {
                (self.last, self.motion) = (self.without_limp_legs(command), motion);
            }
        }
    }

    /// Time since the newest state; longest if there was none.
    pub(crate) fn silence(&self, now: Duration) -> Duration {
        self.heard.map_or(Duration::MAX, |heard| now.saturating_sub(heard))
    }

    pub(crate) fn measured(&self) -> Joints {
        self.sensors.as_ref().map_or(Joints::all(0.0), |sensors| sensors.angles)
    }

    pub(crate) fn lies(&self) -> bool {
        self.sensors.as_ref().is_some_and(|sensors| is_lying(&sensors.inertial))
    }

    /// A command does not make the legs of a standing robot limp.
    fn without_limp_legs(&self, command: &Command) -> Command {
        let mut command = *command;
        if !self.lies() {
            for &joint in self.body.motors {
                if self.body.is_in_leg(joint) && command.stiffness[joint] <= 0.0 {
                    command.stiffness[joint] = self.last.stiffness[joint];
                    command.targets[joint] = self.last.targets[joint];
                }
            }
        }
        command
    }

    fn wait(&mut self, now: Duration, waiting: Waiting) {
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

    fn prepare(&mut self, now: Duration, mut preparing: Preparing) {
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

    fn enter(&mut self, now: Duration) {
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

    fn start(&mut self, now: Duration) {
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

    fn rise(&mut self, now: Duration, transition: &Transition) {
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

    pub(crate) fn follow(&mut self, now: Duration, is_new: bool) {
        if !self.may_command(now) {
            return;
        }
        if self.silence(now) > REST {
            if self.since_sent(now) >= CYCLE {
                self.rest(now);
            }
            return;
        }
        if is_new {
            self.command(now);
        } else if self.since_sent(now) >= LATE {
            self.counts.late += 1;
            self.command(now);
        }
        self.offer(now);
    }

    /// Offers the robot program a cycle if it is time to.
    pub(crate) fn offer(&mut self, now: Duration) {
        let since = self.offered.map_or(CYCLE, |offered| now.saturating_sub(offered));
        if !self.is_answered || since < CYCLE {
            return;
        }
        let Some(mut sensors) = self.sensors else { return };
        let (roll, pitch) = (sensors.inertial.roll, sensors.inertial.pitch);
        self.estimator.complete(&mut sensors, since.min(10 * CYCLE).as_secs_f32());
        // The robot's own estimate is better than that of this filter, which serves the forces on the soles.
        (sensors.inertial.roll, sensors.inertial.pitch) = (roll, pitch);
        (self.offered, self.is_answered) = (Some(now), false);
        self.counts.cycles += 1;
        self.out.cycle = Some(sensors);
    }

    fn since_sent(&self, now: Duration) -> Duration {
        self.sent.map_or(Duration::MAX, |sent| now.saturating_sub(sent))
    }

    /// Sends the last targets.
    pub(crate) fn command(&mut self, now: Duration) {
        let seconds = self.since_sent(now).min(Duration::from_secs(1)).as_secs_f32();
        let (targets, stiffness) = (self.last.targets, self.last.stiffness);
        let command = self.limiter.command(&targets, &stiffness, &self.measured(), seconds);
        self.put(now, command);
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

    fn find_mode(&mut self, now: Duration) {
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

    fn damp(&mut self, now: Duration) {
        self.stay_limp(now);
        if self.limp_since.is_none_or(|since| now.saturating_sub(since) >= BEFORE_CHANGE) {
            self.want(now, Mode::Damping);
        }
        if self.modes.known(now) == Some(Mode::Damping) {
            self.phase = Phase::Waiting(Waiting { needed: HEARD_AGAIN, since: None });
        }
    }

    fn follow_firmware(&mut self, now: Duration) {
        if self.silence(now) > SILENT {
            return self.begin_damping();
        }
        let mode = self.modes.known(now);
        match self.firmware.standing(now, mode) {
            Standing::Walks => {
                let motion = if self.silence(now) > REST { Motion::default() } else { self.motion };
                let requests = self.firmware.go(now, &mut self.modes, &motion);
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

    /// Whether the program has the motors.
    pub(crate) const fn has_gains(&self) -> bool {
        self.has_gains
    }

    pub(crate) const fn ends_with(&mut self, ending: Ending) {
        self.phase = Phase::Ending(ending);
    }
}

/// Largest pitch of the shoulders, rad.
fn shoulder(angles: &Joints) -> f32 {
    use bica_motion::joints::Joint;
    angles[Joint::LShoulderPitch].abs().max(angles[Joint::RShoulderPitch].abs())
}
