//! The robot's side of a run, on a thread of its own: answers maps in time, and ends the run in order.

use std::sync::PoisonError;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica_camera::{Images, monotonic};
use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::{CameraId, Command, Lights};

use crate::actuator_map::ActuatorMap;
use crate::connection::{Connection, Event};
use crate::cycle::{Cycle, Message};
use crate::ending::{Reason, Watch};
use crate::heads::Heads;
use crate::limiter::Limiter;
use crate::mistake::Mistake;
use crate::options::{Options, Standing};
use crate::pace::Pace;
use crate::phase::{Halt, LIMP, Phase, Rise, SitDown, Sitting, holding};
use crate::posture::{is_in_leg, is_low};
use crate::sensor_map::SensorMap;

/// Longest time from the request to end until the end.
const LONGEST_END: Duration = Duration::from_secs(11);
/// Time after which a robot that sends no maps is not waited for at the end.
const LONGEST_SILENCE: Duration = Duration::from_secs(5);
/// Time after which it is looked again whether the end was requested, and for which a command is waited for then.
const LOOK: Duration = Duration::from_millis(50);
const LONGEST_LAST_REPLY: Duration = Duration::from_secs(1);
/// Least time between two lines about maps that were not used.
const BETWEEN_REJECTIONS: Duration = Duration::from_secs(1);

/// A NAO V6 behind its socket. The robot program is on another thread.
///
/// Each map goes to the robot program if that is free, and is answered with its command. If a robot in real time would get its answer
/// late, it gets the newest targets; the late command then counts for the next map.
pub(crate) struct Driver {
    options: Options,
    connection: Connection,
    limiter: Limiter,
    watch: Watch,
    phase: Phase,
    pace: Pace,
    /// The last map.
    map: SensorMap,
    cycles: Sender<Cycle>,
    messages: Receiver<Message>,
    /// Number of the map that the robot program works on, and since when.
    given: Option<(u64, Clock)>,
    /// The newest command since the robot stood up.
    newest: Option<Command>,
    images: Option<Images>,
    heads: Heads,
    standing: Standing,
    /// When the last valid map came, and when bytes were last dropped.
    heard: Clock,
    rejected: Option<Clock>,
    /// When the end must be reached.
    deadline: Option<Clock>,
}

impl Driver {
    pub(crate) fn new(
        options: Options,
        connection: Connection,
        images: Option<Images>,
        (cycles, messages): (Sender<Cycle>, Receiver<Message>),
    ) -> Self {
        Self {
            options,
            connection,
            limiter: Limiter::default(),
            watch: Watch::default(),
            phase: Phase::Rise(Rise::default()),
            pace: Pace::default(),
            map: SensorMap::default(),
            cycles,
            messages,
            given: None,
            newest: None,
            images,
            heads: Heads::default(),
            standing: Standing::default(),
            heard: Clock::now(),
            rejected: None,
            deadline: None,
        }
    }

    /// Lets a robot sit down whose program was killed after this map, of which so many were not answered.
    pub(crate) fn take_over(mut self, limiter: Limiter, map: &SensorMap, unanswered: u64) {
        self.standing = Standing { maps: 1, opened: 1, ..Standing::default() };
        (self.limiter, self.map, self.phase) = (limiter, *map, Phase::Follow);
        (0..unanswered).for_each(|_| self.repeat());
        self.leave(Reason::Dropped);
        self.run();
    }

    /// Runs until the robot sits, or does not answer.
    pub(crate) fn run(mut self) {
        while self.phase != Phase::Over {
            self.check_end();
            if self.phase == Phase::Over {
                break;
            }
            match self.connection.wait() {
                Event::Opened(unguarded) => self.opened(unguarded),
                Event::Closed => self.say("the socket was closed, and is opened again"),
                Event::Rejected(mistake) => self.reject(&mistake),
                Event::Map(map) => self.take(&map),
                Event::Silence => {}
            }
        }
        self.publish();
        if self.standing.reason == Some(Reason::Hangs) {
            (self.options.abandon)();
        }
    }

    fn publish(&self) {
        *self.options.standing.lock().unwrap_or_else(PoisonError::into_inner) = self.standing;
    }

    fn say(&self, text: &str) {
        (self.options.say)(text);
    }

    fn opened(&mut self, unguarded: Option<String>) {
        if let Some(reason) = unguarded {
            self.say(&format!("the guard cannot be started, so a killed program leaves the robot standing: {reason}"));
        }
        self.standing.opened += 1;
        self.limiter.reset();
        (self.pace, self.newest) = (Pace::default(), None);
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

    /// Takes a map, and answers it.
    fn take(&mut self, map: &SensorMap) {
        (self.map, self.heard) = (*map, Clock::now());
        self.heads.push(monotonic(), map);
        self.standing.maps += 1;
        self.standing.identity = Some(map.identity);
        if self.standing.reason.is_none() {
            let is_late = self.options.limit.is_some_and(|limit| self.standing.seconds() >= limit);
            let is_stopped = (self.options.stop)();
            let reason = self.watch.look(map).or_else(|| is_stopped.then_some(Reason::Signal));
            if let Some(reason) = reason.or_else(|| is_late.then_some(Reason::TimeUp)) {
                self.end(reason);
            }
        }
        match self.phase {
            Phase::Rise(rise) => self.rise(rise),
            Phase::Follow => self.ask(),
            Phase::Halt(halt) => self.halt(halt),
            Phase::Sit(sit) => self.sit(sit),
            Phase::Limp(left) => self.rest(left),
            Phase::Over => {}
        }
    }

    fn rise(&mut self, mut rise: Rise) {
        let targets = rise.step(&self.map, &self.limiter);
        self.phase = if targets.is_some() { Phase::Rise(rise) } else { Phase::Follow };
        let Some(targets) = targets else { return self.ask() };
        if let Some(delay) = self.pace.measure(self.heard) {
            thread::sleep(delay);
        }
        self.answer(&targets, &holding());
    }

    fn halt(&mut self, mut halt: Halt) {
        if halt.step(&self.map, &self.limiter) {
            return self.sit(SitDown::default());
        }
        self.phase = Phase::Halt(halt);
        self.ask();
    }

    /// Answers with the command of the robot program to this map, or with its newest one if that is late.
    fn ask(&mut self) {
        if self.is_behind() {
            self.standing.late += 1;
        } else {
            self.give();
            self.listen();
            self.is_behind();
        }
        self.follow();
    }

    /// Whether the next map is here already.
    fn is_behind(&mut self) -> bool {
        let is_behind = self.connection.has_next();
        if is_behind {
            self.pace.is_ahead();
        }
        is_behind
    }

    /// Gives the map to the robot program if that is free.
    fn give(&mut self) {
        let halt = match self.phase {
            Phase::Follow => None,
            Phase::Halt(halt) => Some(halt.cycle),
            _ => return,
        };
        if self.given.is_none() {
            let camera = self.newest.map_or(CameraId::Top, |command| command.camera);
            let is_in_step = self.pace.deadline(self.heard).is_none();
            let maps = self.standing.maps;
            // A robot does not run for a year.
            let number = u32::try_from(maps - 1).unwrap_or(u32::MAX);
            let image = self.images.as_ref().and_then(|images| images.take(camera, number, is_in_step));
            let taken = image.as_ref().and_then(|image| image.taken);
            let map = taken.map_or(self.map, |taken| self.heads.at(taken, &self.map));
            self.given = Some((maps, Clock::now()));
            // Without a program, the next message says so.
            _ = self.cycles.send(Cycle { map, maps, image, halt });
        }
    }

    /// Waits for the command to this map, as long as the robot does and the program may take.
    fn listen(&mut self) {
        while let Some((_, since)) = self.given {
            let until = self.pace.deadline(self.heard).unwrap_or_else(|| since + self.patience());
            let left = until.saturating_duration_since(Clock::now());
            match self.messages.recv_timeout(left.min(LOOK)) {
                Ok(message) if self.hear(message) => break,
                Ok(_) => self.give(),
                Err(RecvTimeoutError::Disconnected) => self.leave(Reason::Dropped),
                Err(RecvTimeoutError::Timeout) if left > LOOK => {}
                Err(RecvTimeoutError::Timeout) => {
                    self.standing.late += 1;
                    break;
                }
            }
        }
    }

    /// Longest time that the robot program may take for a command: shorter when the run should end.
    fn patience(&self) -> Duration {
        let ends = self.standing.reason.is_some() || (self.options.stop)();
        if ends { self.options.patience.min(LONGEST_LAST_REPLY) } else { self.options.patience }
    }

    /// Takes a message of the robot program, which is free then; returns whether it is the command to this map.
    fn hear(&mut self, message: Message) -> bool {
        let is_answer = self.given.take().is_some_and(|(number, _)| number == self.standing.maps);
        match message {
            Ok(command) => self.newest = Some(command),
            Err(reason) => self.leave(reason),
        }
        is_answer
    }

    /// Goes on without the robot program.
    fn leave(&mut self, reason: Reason) {
        (self.given, self.newest) = (None, None);
        if matches!(self.phase, Phase::Follow | Phase::Halt(_)) || self.standing.reason.is_none() {
            self.end(reason);
        }
    }

    fn sit(&mut self, mut sit: SitDown) {
        let step = sit.step(&self.map, &self.limiter);
        self.phase = Phase::Sit(sit);
        match step {
            Sitting::Moves(targets) => self.answer(&targets, &holding()),
            Sitting::IsLow => self.rest(LIMP),
            Sitting::IsStuck => {
                self.repeat();
                self.finish("the robot does not sit: its stiffness is left to it; support it, and switch it off");
            }
        }
    }

    fn rest(&mut self, left: u32) {
        self.answer(&self.map.positions(), &Joints::all(0.0));
        self.phase = Phase::Limp(left.saturating_sub(1));
        if left == 0 {
            self.standing.is_low = true;
            self.finish("the robot sits, and its joints are limp");
        }
    }

    /// Begins the end.
    fn end(&mut self, reason: Reason) {
        self.say(&format!("{reason}; the robot sits down"));
        self.standing.reason = Some(reason);
        self.deadline = Some(Clock::now() + LONGEST_END);
        let has_program = self.phase == Phase::Follow && !reason.is_of_program();
        self.phase = if has_program { Phase::Halt(Halt::default()) } else { Phase::Sit(SitDown::default()) };
    }

    /// Begins the end on request; gives up if it cannot be reached.
    fn check_end(&mut self) {
        while let Ok(message) = self.messages.try_recv() {
            self.hear(message);
        }
        if self.given.is_some_and(|(_, since)| since.elapsed() >= self.patience()) {
            self.leave(Reason::Hangs);
        }
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
        self.publish();
        let lights = self.newest.map_or_else(Lights::default, |command| command.lights);
        self.connection.send(&ActuatorMap { position, stiffness, lights }.encode());
    }

    /// Answers with the last targets.
    fn repeat(&mut self) {
        let targets = self.limiter.targets(&self.map.positions());
        self.answer(&targets, &self.limiter.stiffness());
    }

    /// Answers with the newest command, or with the last targets before the first one.
    fn follow(&mut self) {
        match self.newest {
            Some(command) => self.answer(&command.targets, &self.allowed(&command.stiffness)),
            None => self.repeat(),
        }
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
