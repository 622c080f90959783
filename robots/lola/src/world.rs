//! The real robot as a world.

use std::io;
use std::sync::{Arc, PoisonError};
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::Instant;
use bica::runner::{Robot, World};
use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::{CameraId, Command, Lights, Sensors};

use crate::CYCLE_MICROS;
use crate::actuator_map::ActuatorMap;
use crate::connection::{Connection, Event};
use crate::ending::{Reason, Watch};
use crate::frames::{Frame, Mailbox, Receiver};
use crate::limiter::Limiter;
use crate::mistake::Mistake;
use crate::options::{Options, Standing};
use crate::phase::{Halt, LIMP, Phase, Rise, SitDown, Sitting, holding};
use crate::posture::{is_in_leg, is_low};
use crate::sensor_map::SensorMap;

/// Longest time from the request to end until the end.
const LONGEST_END: Duration = Duration::from_secs(11);
/// Time after which a robot that sends no maps is not waited for at the end.
const LONGEST_SILENCE: Duration = Duration::from_secs(5);
/// Least time between two lines about maps that were not used.
const BETWEEN_REJECTIONS: Duration = Duration::from_secs(1);

/// A NAO V6 behind its socket.
///
/// The robot paces: each valid sensor map is answered once, and the time of this world is 12 ms times their number. When the run ends, for
/// whatever reason, the robot sits down before its joints become limp; so it does when this value is dropped.
pub struct LolaWorld {
    options: Options,
    connection: Connection,
    limiter: Limiter,
    watch: Watch,
    phase: Phase,
    /// The map of this cycle.
    map: SensorMap,
    /// Whether it is not answered yet.
    is_pending: bool,
    command: Command,
    mailbox: Arc<Mailbox>,
    image: Option<Frame>,
    standing: Standing,
    /// When the last valid map came, and when bytes were last dropped.
    heard: Clock,
    rejected: Option<Clock>,
    /// When the end must be reached.
    deadline: Option<Clock>,
    /// Ends last.
    _receiver: Option<Receiver>,
}

impl LolaWorld {
    /// Waits for the robot, and lets it stand up. Returns before if the program is asked to end.
    ///
    /// # Errors
    /// If there is no thread for the images.
    pub fn open(options: Options) -> io::Result<Self> {
        let mailbox = Arc::<Mailbox>::default();
        let start = |path| Receiver::start(path, Arc::clone(&mailbox), options.say);
        let receiver = options.frames.clone().map(start).transpose()?;
        let connection = Connection::new(options.socket.clone(), options.guard);
        let mut world = Self::with(options, connection, mailbox, receiver);
        world.say(&format!("waits for the robot at {}", world.connection.path().display()));
        world.advance();
        Ok(world)
    }

    /// A robot whose program was killed, after its last map, of which this number was not answered: it sits down when this value is
    /// dropped.
    pub(crate) fn taken_over(
        connection: Connection,
        limiter: Limiter,
        map: &SensorMap,
        unanswered: u64,
        say: fn(&str),
    ) -> Self {
        let options = Options {
            socket: connection.path().to_owned(),
            frames: None,
            guard: None,
            limit: None,
            stop: Box::new(|| false),
            say,
            halt: |_, _, _| (),
            standing: Arc::default(),
        };
        let standing = Standing { maps: 1, opened: 1, ..Standing::default() };
        let mut world = Self::with(options, connection, Arc::default(), None);
        (world.limiter, world.map, world.standing, world.phase) = (limiter, *map, standing, Phase::Follow);
        (0..unanswered).for_each(|_| world.repeat());
        world
    }

    fn with(options: Options, connection: Connection, mailbox: Arc<Mailbox>, receiver: Option<Receiver>) -> Self {
        Self {
            connection,
            options,
            limiter: Limiter::default(),
            watch: Watch::default(),
            phase: Phase::Rise(Rise::default()),
            map: SensorMap::default(),
            is_pending: false,
            command: Command::new(Joints::all(0.0), 0.0),
            mailbox,
            image: None,
            standing: Standing::default(),
            heard: Clock::now(),
            rejected: None,
            deadline: None,
            _receiver: receiver,
        }
    }

    /// Measurements of this cycle, with a new image if there is one.
    #[must_use]
    pub fn sense(&mut self) -> Sensors<'_> {
        let mut sensors = self.map.sensors();
        if let Phase::Halt(halt) = self.phase {
            (self.options.halt)(halt.cycle, &mut sensors.buttons, &self.command);
        }
        Sensors { image: self.image.as_ref().map(Frame::image), ..sensors }
    }

    /// Sends a command within the limits, and waits for the next cycle. Nothing is sent when the run is over.
    pub fn command(&mut self, command: &Command) {
        if self.phase != Phase::Over {
            self.command = *command;
            self.answer(&command.targets, &self.allowed(&command.stiffness));
            self.advance();
        }
    }

    /// Whether the run is over: the robot sits, or does not answer.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.phase == Phase::Over
    }

    fn say(&self, text: &str) {
        (self.options.say)(text);
    }

    /// Answers maps until one is the robot program's, or the run is over.
    fn advance(&mut self) {
        loop {
            self.check_end();
            if self.phase == Phase::Over {
                break;
            }
            match self.connection.wait() {
                Event::Opened(unguarded) => self.opened(unguarded),
                Event::Closed => self.say("the socket was closed, and is opened again"),
                Event::Rejected(mistake) => self.reject(&mistake),
                Event::Map(map) if self.take(&map) => break,
                Event::Silence | Event::Map(_) => {}
            }
        }
        *self.options.standing.lock().unwrap_or_else(PoisonError::into_inner) = self.standing;
    }

    fn opened(&mut self, unguarded: Option<String>) {
        if let Some(reason) = unguarded {
            self.say(&format!("the guard cannot be started, so a killed program leaves the robot standing: {reason}"));
        }
        self.standing.opened += 1;
        self.limiter.reset();
        self.is_pending = false;
        let ends = self.standing.reason.is_some();
        self.phase = if ends { Phase::Sit(SitDown::default()) } else { Phase::Rise(Rise::default()) };
        self.say("the socket is open: the robot stands up from where it is");
    }

    fn reject(&mut self, mistake: &Mistake) {
        self.standing.rejected += 1;
        if self.rejected.is_none_or(|last| last.elapsed() > BETWEEN_REJECTIONS) {
            self.say(&format!("a map was not used: {mistake}"));
        }
        self.rejected = Some(Clock::now());
    }

    /// Takes the map of a cycle; returns whether the robot program answers it.
    fn take(&mut self, map: &SensorMap) -> bool {
        (self.map, self.is_pending, self.heard) = (*map, true, Clock::now());
        self.standing.maps += 1;
        if self.standing.reason.is_none() {
            let is_late = self.options.limit.is_some_and(|limit| self.seconds() >= limit);
            let is_stopped = (self.options.stop)();
            let reason = self.watch.look(map).or_else(|| is_stopped.then_some(Reason::Signal));
            if let Some(reason) = reason.or_else(|| is_late.then_some(Reason::TimeUp)) {
                self.end(reason);
            }
        }
        match self.phase {
            Phase::Rise(rise) => self.rise(rise),
            Phase::Follow if self.connection.is_late() => {
                self.standing.late += 1;
                self.repeat();
                false
            }
            Phase::Follow => self.see(),
            Phase::Halt(halt) => self.halt(halt),
            Phase::Sit(sit) => self.sit(sit),
            Phase::Limp(left) => self.rest(left),
            Phase::Over => false,
        }
    }

    fn rise(&mut self, mut rise: Rise) -> bool {
        let targets = rise.step(&self.map, &self.limiter);
        self.phase = if targets.is_some() { Phase::Rise(rise) } else { Phase::Follow };
        match targets {
            Some(targets) => self.answer(&targets, &holding()),
            None => return self.see(),
        }
        false
    }

    fn halt(&mut self, mut halt: Halt) -> bool {
        if halt.step(&self.map, &self.limiter) {
            return self.sit(SitDown::default());
        }
        self.phase = Phase::Halt(halt);
        self.see()
    }

    fn sit(&mut self, mut sit: SitDown) -> bool {
        let step = sit.step(&self.map, &self.limiter);
        self.phase = Phase::Sit(sit);
        match step {
            Sitting::Moves(targets) => self.answer(&targets, &holding()),
            Sitting::IsLow => return self.rest(LIMP),
            Sitting::IsStuck => {
                self.repeat();
                self.finish("the robot does not sit: its stiffness is left to it; support it, and switch it off");
            }
        }
        false
    }

    fn rest(&mut self, left: u32) -> bool {
        self.answer(&self.map.positions(), &Joints::all(0.0));
        self.phase = Phase::Limp(left.saturating_sub(1));
        if left == 0 {
            self.standing.is_low = true;
            self.finish("the robot sits, and its joints are limp");
        }
        false
    }

    /// Takes the image of this cycle.
    fn see(&mut self) -> bool {
        // A robot does not run for a year.
        let number = u32::try_from(self.standing.maps - 1).unwrap_or(u32::MAX);
        self.image = self.mailbox.take(self.command.camera, number);
        true
    }

    /// Time of the world, s.
    fn seconds(&self) -> f64 {
        (self.standing.maps * CYCLE_MICROS) as f64 * 1e-6
    }

    /// Begins the end.
    fn end(&mut self, reason: Reason) {
        self.say(&format!("{reason}; the robot sits down"));
        self.standing.reason = Some(reason);
        self.deadline = Some(Clock::now() + LONGEST_END);
        let has_program = self.phase == Phase::Follow && !matches!(reason, Reason::Dropped | Reason::Panic);
        self.phase = if has_program { Phase::Halt(Halt::default()) } else { Phase::Sit(SitDown::default()) };
    }

    /// Begins the end on request; gives up if it cannot be reached.
    fn check_end(&mut self) {
        if self.standing.reason.is_none() && (self.options.stop)() {
            self.end(Reason::Signal);
        }
        let Some(deadline) = self.deadline else { return };
        if self.phase == Phase::Over {
            return;
        }
        if self.standing.opened == 0 {
            self.finish("the program ends before it has met the robot");
        } else if self.heard.elapsed() > LONGEST_SILENCE {
            self.finish("the robot sends nothing, so that nobody can let it sit down: support it");
        } else if Clock::now() > deadline {
            self.finish("the robot does not sit in time: support it, and switch it off");
        }
    }

    fn finish(&mut self, text: &str) {
        self.say(text);
        self.phase = Phase::Over;
        if !self.standing.is_low {
            self.connection.dismiss();
        }
        self.connection.close();
    }

    /// Answers the map of this cycle within the limits, with targets in rad and stiffness from 0 to 1.
    fn answer(&mut self, targets: &Joints, stiffness: &Joints) {
        let (position, stiffness) = self.limiter.limit(targets, stiffness, &self.map.positions());
        let lights = self.command.lights;
        self.connection.send(&ActuatorMap { position, stiffness, lights }.encode());
        self.is_pending = false;
    }

    /// Answers with the last targets.
    fn repeat(&mut self) {
        let targets = self.limiter.targets(&self.map.positions());
        self.answer(&targets, &self.limiter.stiffness());
    }

    /// Stiffness from 0 to 1 that a robot program may command: it does not make the legs of a standing robot limp.
    fn allowed(&self, stiffness: &Joints) -> Joints {
        let (mut allowed, last) = (*stiffness, self.limiter.stiffness());
        if !is_low(&self.map) {
            for leg in Joint::ALL.into_iter().filter(|joint| is_in_leg(*joint)) {
                if allowed[leg] <= 0.0 {
                    allowed[leg] = last[leg];
                }
            }
        }
        allowed
    }
}

impl<R> World<R> for LolaWorld
where
    R: for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = Command>,
{
    fn now(&self) -> Instant {
        Instant::from_micros(self.standing.maps * CYCLE_MICROS)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.sense()
    }

    fn act(&mut self, command: &Command) {
        self.command(command);
    }

    fn is_over(&self) -> bool {
        self.has_ended()
    }

    fn report(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
        let Standing { maps, rejected, opened, late, reason, .. } = self.standing;
        write!(out, "{maps} maps, {late} of them late, {rejected} not used; the socket was opened {opened} times")?;
        reason.map_or(Ok(()), |reason| write!(out, "; {reason}"))
    }
}

impl Drop for LolaWorld {
    fn drop(&mut self) {
        if self.phase == Phase::Over || self.standing.opened == 0 {
            return;
        }
        if self.is_pending {
            self.repeat();
        }
        if matches!(self.phase, Phase::Follow | Phase::Halt(_)) || self.standing.reason.is_none() {
            let reason = if thread::panicking() { Reason::Panic } else { Reason::Dropped };
            self.command.lights = Lights::default();
            self.command.camera = CameraId::Top;
            self.end(reason);
        }
        self.advance();
    }
}
