//! A microcontroller that thinks in step with a world.

use std::path::Path;

use bica_field::GoalColour;
use bica_motion::robot::{self, Light, Lights};
use bica_wire::message::{Greeting, Hello, Pace, Sensors, Stack};
use bica_wire::{FromRobot, SCHEMA, ToRobot, chunks};

use crate::emulator::{Carrier, Emulator};
use crate::error::Error;

/// A mind on an emulated microcontroller.
#[derive(Debug)]
pub struct Mind {
    emulator: Emulator,
    images: u32,
    /// Instructions in a tick of the robot's clock.
    grain: u64,
}

/// What a cycle brought.
#[derive(Clone, Debug, PartialEq)]
pub struct Thought {
    /// What the robot is to do.
    pub command: robot::Command,
    /// Instructions from sensing to acting.
    pub instructions: u64,
    /// Instructions in each component's own code, in the order of the tree's list.
    pub costs: Vec<u64>,
    /// Whether each component is active.
    pub active: Vec<bool>,
    /// The state of each component's machine.
    pub states: Vec<Option<usize>>,
    /// Images that came with a piece missing, and packets that were damaged or missing.
    pub lost: u32,
}

impl Mind {
    /// Starts an image and tells it where to score; its log goes to a file, as of [`Emulator::start`].
    ///
    /// # Errors
    /// Any [`Error`].
    pub fn start(image: &Path, carrier: Carrier, attack: GoalColour, log: Option<&Path>) -> Result<Self, Error> {
        let mut emulator = Emulator::start(image, carrier, log)?;
        let line = emulator.line();
        let schema = line.hear(greeting(|greeting| greeting.schema))?;
        if schema != SCHEMA {
            return Err(Error::OtherSchema(schema));
        }
        line.say(&ToRobot::Hello(Hello { schema: SCHEMA, pace: Pace::Lockstep, attack }))?;
        let hz = line.hear(greeting(|greeting| greeting.fine_hz))?;
        Ok(Self { emulator, images: 0, grain: 1_000_000_000 / u64::from(hz.max(1)) })
    }

    /// The emulator beneath.
    pub const fn emulator(&mut self) -> &mut Emulator {
        &mut self.emulator
    }

    /// Senses, thinks, acts.
    ///
    /// # Errors
    /// [`Error::Gone`], or [`Error::Unexpected`] if the robot's command is none.
    pub fn think(&mut self, time_us: u64, sensors: &robot::Sensors<'_>) -> Result<Thought, Error> {
        let line = self.emulator.line();
        if let Some(image) = sensors.image {
            self.images = self.images.wrapping_add(1);
            for chunk in chunks(self.images, image.yuyv) {
                line.say(&ToRobot::Chunk(chunk))?;
            }
        }
        line.say(&ToRobot::Sensors(Sensors::new(time_us, sensors, self.images)))?;
        let command = line.hear(|message| match message {
            FromRobot::Command(command) => Some(command),
            _ => None,
        })?;
        if command.time_us != time_us {
            return Err(Error::Unexpected(format!("a command for {} µs at {time_us} µs", command.time_us)));
        }
        let command = command.obeyed().map_err(|error| Error::Unexpected(error.to_string()))?;
        let grain = self.grain;
        line.hear(|message| match message {
            FromRobot::Telemetry(telemetry) => Some(Thought {
                command,
                instructions: u64::from(telemetry.chain) * grain,
                costs: telemetry.cost().map(|ticks| u64::from(ticks) * grain).collect(),
                active: (0..telemetry.states.len()).map(|index| telemetry.active >> index & 1 == 1).collect(),
                states: telemetry.states.iter().map(|&state| (state != u8::MAX).then_some(state.into())).collect(),
                lost: telemetry.torn + telemetry.losses.damaged + telemetry.losses.missing,
            }),
            _ => None,
        })
    }

    /// How much of its stack the robot ever used.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn stack(&mut self) -> Result<Stack, Error> {
        self.emulator.line().say(&ToRobot::Stack)?;
        self.emulator.line().hear(|message| match message {
            FromRobot::Stack(stack) => Some(stack),
            _ => None,
        })
    }
}

/// Every number of a command as it is in memory: equal only for commands that are the same, bit for bit.
pub fn bits(command: &robot::Command) -> impl Iterator<Item = u32> {
    let Lights { chest, left_eye, right_eye } = command.lights;
    let lights = [chest, left_eye, right_eye].map(|Light(red, green, blue)| [red, green, blue]);
    let joints = command.targets.0.into_iter().chain(command.stiffness.0);
    joints.chain(lights.into_iter().flatten()).map(f32::to_bits).chain([command.camera as u32])
}

fn greeting<T>(read: impl Fn(Greeting<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| match message {
        FromRobot::Greeting(greeting) => Some(read(greeting)),
        _ => None,
    }
}
