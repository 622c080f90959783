//! A simulated room: a robot that follows its targets, and a person who raises the left arm again and again.
//!
//! In the world `room` there are no forces: the robot always stands, unless an operator pushes it over. In `mujoco` there are.

mod body;

use std::collections::VecDeque;
use std::f32::consts::PI;
use std::fmt;
use std::path::{Path, PathBuf};

use bica::prelude::*;
use bica::runner::World;
use bica_app::{Console, Failure, WorldOptions};
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::pose::Pose2;
use bica_motion::robot::Inertial;
use rand_pcg::{Pcg32, rand_core::Rng};

use self::body::Body;
use crate::body::Sounding;
use crate::cli;
use crate::exercise::Judgement;
use crate::input::Pressed;
use crate::record::Record;
use crate::robot::{Command, Order, Sensors, Therapist};
use crate::session::Signal;
use crate::skeleton::{Person, Skeleton};
use crate::speech::{self, Player};

/// Cycles of a second.
const RATE: u64 = 100;
/// A skeleton comes every so many cycles: 20 a second.
const SKELETON: u64 = 5;
/// Time of a repetition of the person, s.
const REPETITION: f32 = 4.0;

/// The room.
pub struct Room {
    cycle: u64,
    orders: VecDeque<Order>,
    /// Cycle in which a person presses the button in the chest to start.
    start: Option<u64>,
    body: Body,
    sound: Sounding,
    /// Cycles for which something is pressed.
    pressed: (Option<Signal>, u64),
    hot: bool,
    person: Option<Pcg32>,
    /// Highest angle of the arm in this repetition, degrees.
    peak: f32,
    /// What began and ended, with its time.
    log: Vec<String>,
    record: Option<Record>,
    player: Option<Player>,
}

impl Room {
    /// A room for the options of a run: `session` is a file, `person` is `yes` or `no`, `start` too. With `code`, a record is kept in
    /// the folder `records`. With `sound`, texts are spoken into this folder, and all sounds are played.
    ///
    /// # Errors
    /// If an option is missing or wrong, or the session has an error.
    pub fn open(options: &WorldOptions) -> Result<Self, Failure> {
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
        let yes = |name| options.value(name, "yes".to_owned()).map(|value| value == "yes");
        let mut room = Self::new(script.orders(folder), options.seed, yes("person")?, yes("start")?);
        room.player = (!sound.is_empty()).then(|| Player::new(&script, folder, "paplay"));
        let (code, records) = (options.value("code", String::new())?, options.value("records", ".".to_owned())?);
        if !code.is_empty() {
            room.record = Some(Record::begin(Path::new(&records), &code, &script.title, script.lines)?);
        }
        Ok(room)
    }

    /// The same with forces.
    ///
    /// # Errors
    /// As for [`open`](Self::open), or if MuJoCo is not there.
    pub fn open_with_forces(options: &WorldOptions) -> Result<Self, Failure> {
        Self::open(options)?.with_forces(options.seed)
    }

    /// Replaces the robot's body by one with forces.
    ///
    /// # Errors
    /// If MuJoCo is not there.
    pub fn with_forces(mut self, seed: u64) -> Result<Self, Failure> {
        self.body = Body::with_forces(seed)?;
        Ok(self)
    }

    /// Where the robot stands on the floor, from where it began: m, rad. Without forces it stays there.
    #[must_use]
    pub fn place(&self) -> Pose2 {
        self.body.place()
    }

    /// How often the robot fell.
    #[must_use]
    pub const fn falls(&self) -> usize {
        self.body.falls()
    }

    /// A room where a session is loaded, and started if wanted.
    #[must_use]
    pub fn new(orders: Vec<Order>, seed: u64, person: bool, start: bool) -> Self {
        Self {
            cycle: 0,
            start: start.then_some(orders.len() as u64 + RATE),
            orders: orders.into(),
            body: Body::ideal(),
            sound: Sounding::default(),
            pressed: (None, 0),
            hot: false,
            person: person.then(|| Pcg32::new(seed, 1)),
            peak: 100.0,
            log: Vec::new(),
            record: None,
            player: None,
        }
    }

    /// Angles of the joints, rad.
    #[must_use]
    pub fn angles(&self) -> Joints {
        self.body.angles()
    }

    /// What sounds.
    #[must_use]
    pub const fn sound(&self) -> Sounding {
        self.sound
    }

    /// What began and ended, with its time.
    #[must_use]
    pub fn log(&self) -> &[String] {
        &self.log
    }

    /// The person: raises the left arm and lowers it, with a rest of a fourth of the time.
    fn person(&mut self) -> Option<Skeleton> {
        let random = self.person.as_mut()?;
        let time = (self.cycle % (RATE * REPETITION as u64)) as f32 / RATE as f32;
        if time == 0.0 {
            self.peak = 98.0 + 4.0 * (random.next_u32() as f32 / u32::MAX as f32);
        }
        let raised = libm::sinf(PI * (time / REPETITION - 0.25).max(0.0) / 0.75);
        Some(Person { peak: self.peak, ..Person::STILL }.at(raised))
    }
}

/// What an operator can do.
#[world_actions]
impl Room {
    /// Presses or touches the robot.
    #[action]
    pub const fn press(
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
    pub fn push_over(&mut self, fallen: bool) {
        self.body.push_over(fallen);
    }

    /// Makes a motor hot or cool.
    #[action]
    pub const fn heat(&mut self, hot: bool) {
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
        self.body.act(command);
        if command.sound != self.sound {
            self.log.push(format!("{:8.2} s  {:?}", self.cycle as f32 / RATE as f32, command.sound));
        }
        self.sound = command.sound;
        if let Some(Err(error)) = self.player.as_mut().map(|player| player.play(command.sound)) {
            self.log.push(format!("`paplay` does not play, so there is no sound: {error}"));
            self.player = None;
        }
        if let Some(noted) = &command.noted {
            let seconds = self.cycle as f32 / RATE as f32;
            let Judgement { verdict, reasons } = noted.judgement;
            let reasons: Vec<_> = reasons.names().collect();
            self.log.push(format!("{seconds:8.2} s  {} {}", verdict.name(), reasons.join(", ")));
            if let Some(Err(failure)) = self.record.as_mut().map(|record| record.note(seconds, noted)) {
                self.log.push(format!("{failure:?}"));
            }
        }
        self.pressed.1 = self.pressed.1.saturating_sub(1);
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        self.log.iter().try_for_each(|line| writeln!(out, "{line}"))
    }
}
