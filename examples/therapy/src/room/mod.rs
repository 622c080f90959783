//! Simulated room with the robot and a person who raises the left arm periodically.
//!
//! The world `room` has no forces: the robot follows its targets, and stands unless an operator pushes it over. The
//! world `mujoco` has forces.

mod body;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;
use std::f32::consts::PI;
use std::fmt;
use std::path::{Path, PathBuf};

use bica::prelude::*;
use bica::runner::World;
use bica_app::{Console, Failure, WorldOptions};
use bica_body::random::Random;
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::robot::Inertial;

use self::body::Body;
use crate::body::Sounding;
use crate::cli;
use crate::input::Pressed;
use crate::record::Record;
use crate::robot::{Command, Order, Sensors, Therapist};
use crate::session::Signal;
use crate::skeleton::{Person, Skeleton};
use crate::speech::{self, Player};

/// Cycles per second.
const RATE: u64 = 100;
/// Cycles from one skeleton to the next: 20 skeletons per second.
const SKELETON: u64 = 5;
/// Duration of a repetition of the person, s.
const REPETITION: f32 = 4.0;

/// Simulated room.
#[derive(Default)]
pub(crate) struct Room {
    cycle: u64,
    orders: VecDeque<Order>,
    /// Cycle in which the button in the chest is pressed to start the session.
    start: Option<u64>,
    body: Body,
    sound: Sounding,
    /// Signal that is pressed, and the number of cycles left.
    pressed: (Option<Signal>, u64),
    hot: bool,
    person: Option<Random>,
    /// Highest angle of the arm in this repetition, degrees.
    peak: f32,
    /// Text and time of each start and end.
    log: Vec<String>,
    record: Option<Record>,
    player: Option<Player>,
}

impl Room {
    /// Opens a room with the options of a run: `session` is a file; `person` and `start` are `true` or `false`. With
    /// `code`, a record is written to the folder `records`. With `sound`, texts are synthesized into this folder, and
    /// all sounds are played.
    pub(crate) fn open(options: &WorldOptions) -> Result<Self, Failure> {
        let file: PathBuf = options.value("session", String::new())?.into();
        if file.as_os_str().is_empty() {
            return Err(Failure::new("there is no session", "play one: `therapy play FILE`"));
        }
        let mut script = cli::open(&file)?;
        let folder = file.parent().unwrap_or(Path::new(""));
        let sound = options.value("sound", String::new())?;
        if !sound.is_empty()
            && let Err(Failure::Error { what, help }) = speech::speak(&mut script, Path::new(&sound), "espeak-ng")
        {
            let what = format!("warning: {what}; the session goes on without speech\n  help: {help}");
            Console::new(true).print(&what)?;
        }
        let (person, start) = (options.value("person", true)?, options.value("start", true)?);
        let mut room = Self::new(script.orders(folder), options.seed, person, start);
        room.player = (!sound.is_empty()).then(|| Player::new(&script, folder, "paplay"));
        let (code, records) = (options.value("code", String::new())?, options.value("records", ".".to_owned())?);
        if !code.is_empty() {
            room.record = Some(Record::begin(Path::new(&records), &code, &script.title, script.lines)?);
        }
        Ok(room)
    }

    /// Opens the room with a body with forces.
    pub(crate) fn open_with_forces(options: &WorldOptions) -> Result<Self, Failure> {
        Ok(Self { body: Body::with_forces(options.seed)?, ..Self::open(options)? })
    }

    /// Creates a room that loads a session, and starts it if `start` is true.
    fn new(orders: Vec<Order>, seed: u64, person: bool, start: bool) -> Self {
        let start = start.then_some(orders.len() as u64 + RATE);
        Self { start, orders: orders.into(), person: person.then(|| Random::new(seed, 2_u64)), ..Self::default() }
    }

    /// Skeleton of the person, who raises and lowers the left arm and rests for a quarter of the time.
    fn person(&mut self) -> Option<Skeleton> {
        let random = self.person.as_mut()?;
        let time = (self.cycle % (RATE * REPETITION as u64)) as f32 / RATE as f32;
        if time == 0.0 {
            self.peak = random.between(98.0, 102.0);
        }
        let raised = libm::sinf(PI * (time / REPETITION - 0.25).max(0.0) / 0.75);
        Some(Person { peak: self.peak, ..Person::STILL }.at(raised))
    }
}

/// Actions of an operator.
#[world_actions]
impl Room {
    /// Presses or touches the robot.
    #[action]
    pub(crate) const fn press(
        &mut self,
        signal: Signal,
        #[range(0.05..=5.0)]
        #[unit("s")]
        #[default(0.2)]
        seconds: f32,
    ) {
        self.pressed = (Some(signal), (seconds * RATE as f32) as u64);
    }

    /// Pushes the robot over, or puts it on its feet again.
    #[action]
    pub(crate) fn push_over(&mut self, fallen: bool) {
        self.body.push_over(fallen);
    }

    /// Makes a motor hot or cool.
    #[action]
    pub(crate) const fn heat(&mut self, hot: bool) {
        self.hot = hot;
    }
}

impl World<Therapist> for Room {
    fn now(&self) -> Instant {
        Instant::from_millis(self.cycle * 1000 / RATE)
    }

    fn sensors(&mut self) -> Sensors {
        let order = self.orders.get(self.cycle as usize).copied();
        if self.start == Some(self.cycle) {
            self.press(Signal::Chest, 0.2);
        }
        let measured = self.body.sense();
        let Inertial { gyro, roll, pitch, .. } = measured.inertial;
        let temperatures = if self.hot { Joints([72.0; JOINTS]) } else { measured.temperatures };
        let person = if self.cycle.is_multiple_of(SKELETON) { self.person() } else { None };
        let mut pressed = Pressed::default();
        if let (Some(signal), 1..) = self.pressed {
            pressed[signal as usize] = true;
        }
        Sensors {
            angles: measured.angles,
            temperatures,
            tilt: [roll, pitch],
            gyro: gyro.to_array(),
            feet: [measured.left_foot, measured.right_foot],
            pressed,
            battery: 0.8,
            person,
            order,
        }
    }

    fn act(&mut self, command: &Command) {
        let seconds = self.cycle as f32 / RATE as f32;
        if self.body.act(command) {
            self.log.push(format!("{seconds:8.2} s  the robot falls"));
        }
        if command.sound != self.sound {
            let Sounding { speech, music, volume } = command.sound;
            let [speech, music] =
                [speech, music].map(|clip| clip.map_or("none".to_owned(), |clip| format!("sound {}", clip + 1)));
            self.log.push(format!("{seconds:8.2} s  speech: {speech}, music: {music}, volume {:.0} %", 100.0 * volume));
        }
        self.sound = command.sound;
        if let Some(Err(error)) = self.player.as_mut().map(|player| player.play(command.sound)) {
            self.log.push(format!("`paplay` does not play, so there is no sound: {error}"));
            self.player = None;
        }
        if let Some((step, attempt)) = command.noted {
            let (verdict, reasons) = (attempt.reasons.verdict(), attempt.reasons.names().collect::<Vec<_>>());
            self.log.push(format!("{seconds:8.2} s  {} {}", verdict.name(), reasons.join(", ")));
            if let Some(Err(failure)) = self.record.as_mut().map(|record| record.note(seconds, (step, attempt))) {
                self.log.push(format!("{failure:?}"));
            }
        }
        self.pressed.1 = self.pressed.1.saturating_sub(1);
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn is_over(&self) -> bool {
        self.body.failure().is_some()
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        self.log.iter().map(String::as_str).chain(self.body.failure()).try_for_each(|line| writeln!(out, "{line}"))
    }
}
