//! The driver as a function of time and messages: what is sent, and when the robot program gets a cycle.

use std::time::Duration;

use bica_motion::joints::Joints;
use bica_motion::robot::{Command, Sensors};
use bica_motion::senses::SenseEstimator;

use crate::body::Body;
use crate::firmware::{Firmware, Motion};
use crate::limiter::Limiter;
use crate::measured::{is_lying, sensors};
use crate::message::{FallDownState, LowCmd, LowState, RpcReqMsg, RpcRespMsg};
use crate::mode::ModeKeeper;
use crate::phase::{Ending, Phase, Waiting};
use crate::start::HEARD;

/// Time without a state after which the targets rest.
pub(crate) const REST: Duration = Duration::from_millis(50);
/// Time without a state after which the motors damp.
pub(crate) const SILENT: Duration = Duration::from_millis(500);
/// Time that the robot program may take for a cycle, a generous one: a computer may be busy.
const PATIENCE: Duration = Duration::from_secs(30);
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

/// Where a cycle of the robot program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turn {
    /// The robot program computes.
    Offered,
    /// Its answer is not sent yet.
    Fresh,
    /// The next cycle may begin.
    Sent,
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
    pub(crate) estimator: SenseEstimator,
    pub(crate) sensors: Option<Sensors<'static>>,
    /// Time of the newest state, of the newest line about one that was not used, of the newest cycle and of the newest command.
    heard: Option<Duration>,
    rejected_at: Option<Duration>,
    pub(crate) offered: Option<Duration>,
    /// When the next cycle of the robot program begins.
    pub(crate) due: Duration,
    pub(crate) sent: Option<Duration>,
    /// When the gains were taken away.
    pub(crate) limp_since: Option<Duration>,
    pub(crate) has_gains: bool,
    pub(crate) is_given_back: bool,
    pub(crate) turn: Turn,
    pub(crate) last: Command,
    pub(crate) motion: Motion,
    /// When the end was requested.
    pub(crate) stopped: Option<Duration>,
    pub(crate) counts: Counts,
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
            due: Duration::ZERO,
            sent: None,
            limp_since: None,
            has_gains: false,
            is_given_back: false,
            turn: Turn::Sent,
            last: Command::new(body.model.stand, 1.0),
            motion: Motion::default(),
            stopped: None,
            counts: Counts::default(),
        }
    }

    /// Driver of the guard of a program that has the robot: it only listens, until the end is requested because the program is gone.
    #[must_use]
    pub fn guarding(body: &'static Body, gait: Gait, own: u64) -> Self {
        Self { phase: Phase::Guarding, has_gains: gait == Gait::Own, ..Self::new(body, gait, own) }
    }

    /// Looks at what has come until `now`, the time since the start of the program; returns what to send.
    pub fn step(&mut self, now: Duration, inputs: &Inputs<'_>) -> Outputs {
        self.hear(now, inputs);
        let hangs = self.hangs(now);
        if (inputs.stop || hangs) && self.stopped.is_none() {
            if hangs {
                self.say(format!("the robot program hangs: it has not answered for {} s", PATIENCE.as_secs()));
            }
            self.begin_end(now);
        }
        match self.phase {
            Phase::Waiting(waiting) => self.wait(now, waiting),
            Phase::Preparing(preparing) => self.prepare(now, preparing),
            Phase::Entering => self.enter(now),
            Phase::Rising(transition) => self.rise(now, &transition),
            Phase::Following if self.gait == Gait::Firmware => self.follow_firmware(now),
            Phase::Following => self.follow(now),
            Phase::Unknown => self.find_mode(now),
            Phase::Damping => self.damp(now),
            Phase::Left => self.stay_limp(now),
            Phase::Ending(ending) => self.end(now, ending),
            // The program says it.
            Phase::Guarding => self.out.notes.clear(),
            Phase::Over => {}
        }
        let asks = match self.phase {
            Phase::Over => false,
            // A robot that walks by itself is stopped in a mode that is known.
            Phase::Guarding => self.gait == Gait::Firmware,
            _ => self.heard.is_some(),
        };
        if asks {
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

    /// Whether the program has requested a mode of the robot, and not given it back.
    #[must_use]
    pub const fn has_robot(&self) -> bool {
        !matches!(self.phase, Phase::Waiting(_) | Phase::Left | Phase::Over)
    }

    /// Whether the robot program takes too long for its cycle.
    pub(crate) fn hangs(&self, now: Duration) -> bool {
        self.turn == Turn::Offered && self.offered.is_some_and(|offered| now.saturating_sub(offered) >= PATIENCE)
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
            self.turn = Turn::Fresh;
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

    /// Whether the program has the motors.
    pub(crate) const fn has_gains(&self) -> bool {
        self.has_gains
    }

    pub(crate) const fn ends_with(&mut self, ending: Ending) {
        self.phase = Phase::Ending(ending);
    }
}
