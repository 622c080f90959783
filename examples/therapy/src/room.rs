//! A simulated room: a robot that follows its targets, and a person who raises the left arm again and again.
//!
//! There are no forces: the robot always stands, unless an operator pushes it over.

use std::collections::VecDeque;
use std::f32::consts::PI;
use std::fmt;
use std::path::{Path, PathBuf};

use bica::prelude::*;
use bica::runner::World;
use bica_app::{Failure, WorldOptions};
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::model::Nao;
use glam::Vec3;
use rand_pcg::{Pcg32, rand_core::Rng};

use crate::body::{REST, Sounding};
use crate::cli;
use crate::exercise::Judgement;
use crate::input::Pressed;
use crate::record::Record;
use crate::robot::{Command, Order, Seen, Sensors, Therapist};
use crate::session::Step;
use crate::skeleton::{POINTS, Point};

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
    angles: Joints,
    sound: Sounding,
    /// Cycles for which something is pressed.
    pressed: (Pressed, u64),
    fallen: bool,
    hot: bool,
    person: Option<Pcg32>,
    /// Highest angle of the arm in this repetition, degrees.
    peak: f32,
    /// What began and ended, with its time.
    log: Vec<String>,
    record: Option<Record>,
}

impl Room {
    /// A room for the options of a run: `session` is a file, `person` is `yes` or `no`, `start` too. With `code`, a record is kept in
    /// the folder `records`.
    ///
    /// # Errors
    /// If an option is missing or wrong, or the session has an error.
    pub fn open(options: &WorldOptions) -> Result<Self, Failure> {
        let file: PathBuf = options.value("session", String::new())?.into();
        if file.as_os_str().is_empty() {
            return Err(Failure::new("there is no session", "play one: `therapy play FILE`"));
        }
        let script = cli::open(&file)?;
        if let Some(step) = script.steps.iter().position(|step| matches!(step, Step::Walk(_))) {
            let what = format!("{}:{}: this player cannot walk yet", file.display(), script.lines[step]);
            return Err(Failure::new(what, "leave `walk` and `turn` out"));
        }
        let yes = |name| options.value(name, "yes".to_owned()).map(|value| value == "yes");
        let orders = script.orders(file.parent().unwrap_or(Path::new("")));
        let mut room = Self::new(orders, options.seed, yes("person")?, yes("start")?);
        let (code, folder) = (options.value("code", String::new())?, options.value("records", ".".to_owned())?);
        if !code.is_empty() {
            room.record = Some(Record::begin(Path::new(&folder), &code, &script.title, script.lines)?);
        }
        Ok(room)
    }

    /// A room where a session is loaded, and started if wanted.
    #[must_use]
    pub fn new(orders: Vec<Order>, seed: u64, person: bool, start: bool) -> Self {
        Self {
            cycle: 0,
            start: start.then_some(orders.len() as u64 + RATE),
            orders: orders.into(),
            angles: REST,
            sound: Sounding::default(),
            pressed: (Pressed::default(), 0),
            fallen: false,
            hot: false,
            person: person.then(|| Pcg32::new(seed, 1)),
            peak: 100.0,
            log: Vec::new(),
            record: None,
        }
    }

    /// Angles of the joints, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints {
        &self.angles
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
    fn person(&mut self) -> Option<Seen> {
        let random = self.person.as_mut()?;
        let time = (self.cycle % (RATE * REPETITION as u64)) as f32 / RATE as f32;
        if time == 0.0 {
            self.peak = 98.0 + 4.0 * (random.next_u32() as f32 / u32::MAX as f32);
        }
        let raised = libm::sinf(PI * (time / REPETITION - 0.25).max(0.0) / 0.75);
        let (sin, cos) = libm::sincosf((raised * self.peak).to_radians());
        let mut points = [[0.0; 3]; POINTS];
        for (point, at) in [
            (Point::Head, Vec3::new(0.0, 0.7, 0.0)),
            (Point::Neck, Vec3::new(0.0, 0.52, 0.0)),
            (Point::Chest, Vec3::new(0.0, 0.5, 0.0)),
            (Point::LeftShoulder, Vec3::new(-0.2, 0.5, 0.0)),
            (Point::RightShoulder, Vec3::new(0.2, 0.5, 0.0)),
            (Point::LeftElbow, Vec3::new(-0.2 - 0.3 * sin, 0.5 - 0.3 * cos, 0.0)),
            (Point::RightElbow, Vec3::new(0.2, 0.2, 0.0)),
            (Point::LeftHip, Vec3::new(-0.1, 0.0, 0.0)),
            (Point::RightHip, Vec3::new(0.1, 0.0, 0.0)),
        ] {
            points[point as usize] = at.to_array();
        }
        Some(Seen { points, confidence: [1.0; POINTS] })
    }

    fn press(&mut self, pressed: Pressed, seconds: f32) {
        self.pressed = (pressed, (seconds * RATE as f32) as u64);
    }
}

/// What an operator can do.
#[world_actions]
impl Room {
    /// Presses the button in the chest.
    #[action]
    pub fn press_chest(
        &mut self,
        #[range(0.05..=5.0)]
        #[unit("s")]
        #[default(0.2)]
        seconds: f32,
    ) {
        self.press(Pressed { chest: true, ..Pressed::default() }, seconds);
    }

    /// Presses the bumper of the left foot.
    #[action]
    pub fn press_left_bumper(&mut self) {
        self.press(Pressed { left: true, ..Pressed::default() }, 0.2);
    }

    /// Presses the bumper of the right foot.
    #[action]
    pub fn press_right_bumper(&mut self) {
        self.press(Pressed { right: true, ..Pressed::default() }, 0.2);
    }

    /// Touches the head.
    #[action]
    pub fn touch_head(&mut self) {
        self.press(Pressed { head: true, ..Pressed::default() }, 0.2);
    }

    /// Pushes the robot over, or puts it on its feet again.
    #[action]
    pub const fn push_over(&mut self, fallen: bool) {
        self.fallen = fallen;
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
            self.press_chest(0.2);
        }
        let temperature = if self.hot { 72.0 } else { 38.0 };
        let person = if self.cycle.is_multiple_of(SKELETON) { self.person() } else { None };
        let pressed = if self.pressed.1 > 0 { self.pressed.0 } else { Pressed::default() };
        let tilt = [0.0, if self.fallen { 1.5 } else { 0.0 }];
        Sensors { temperatures: Joints([temperature; JOINTS]), tilt, pressed, battery: 0.8, person, order }
    }

    fn act(&mut self, command: &Command) {
        self.angles = self.angles.moved_toward::<Nao>(&command.targets, 1.0 / RATE as f32);
        if command.sound != self.sound {
            self.log.push(format!("{:8.2} s  {:?}", self.cycle as f32 / RATE as f32, command.sound));
        }
        self.sound = command.sound;
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
