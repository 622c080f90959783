//! A robot controller on an emulated microcontroller, in lockstep with a world.

use std::path::Path;

use bica::Tree;
use bica_field::GoalColour;
use bica_motion::robot::{self, Light, Lights};
use bica_player::Forward;
use bica_wire::message::{
    AnswerResult, Change, ClockMode, Hello, Identity, LeaseAction, Request, StackUsage, Telemetry,
};
use bica_wire::model::Invalid;
use bica_wire::{FromMonitor, FromRobot, SCHEMA, ToMonitor, ToRobot, encode};

use super::messages::{MESSAGES, SensorsMessage, decode_command};
use super::qemu::{Emulator, Transport};

/// A robot controller on an emulated microcontroller.
#[derive(Debug)]
pub struct Controller {
    emulator: Emulator,
    last_image_id: u32,
    instructions_per_tick: u64,
    image_bytes: usize,
    /// Number of the lease of this operator; `None` before the first request.
    lease: Option<u64>,
    last_request: u32,
}

/// Result of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleReport {
    /// Command for the robot.
    pub command: robot::Command,
    /// Number of instructions from sensing to acting.
    pub instructions: u64,
    /// Number of instructions in each component's own code, in the order of the tree's list.
    pub costs: Vec<u64>,
    /// Whether each component is active.
    pub active: Vec<bool>,
    /// Index of the current state of each component; `None` without a state machine.
    pub states: Vec<Option<usize>>,
    /// Total number of incomplete images and of damaged or missing packets.
    pub lost: u32,
}

impl Controller {
    /// Starts an image and a game in which the robot attacks the goal of a colour. The log is written to a file, as by
    /// [`Emulator::start`].
    ///
    /// # Errors
    /// If QEMU cannot be started with the image, or the image is of other sources.
    pub fn start(image: &Path, transport: Transport, attacks: GoalColour, log: Option<&Path>) -> Result<Self, Invalid> {
        Self::start_on(Emulator::start(image, transport, log)?, attacks)
    }

    /// Starts a game, in which the robot attacks the goal of a colour, on an image that was just started.
    ///
    /// # Errors
    /// If QEMU cannot be started with the image, or the image is of other sources.
    pub fn start_on(mut emulator: Emulator, attacks: GoalColour) -> Result<Self, Invalid> {
        let link = emulator.link();
        let schema = link.receive_schema()?;
        if schema != SCHEMA {
            return Err(super::error(format!("the image has schema {schema:016x}, this program {SCHEMA:016x}")));
        }
        let mut set_up = [0; 8];
        let set_up = encode(&attacks, &mut set_up).unwrap_or_default();
        let clock_mode = ClockMode::Lockstep;
        link.send(&ToRobot::Hello(Hello { schema: SCHEMA, messages: MESSAGES, clock_mode, set_up }))?;
        let (messages, counter_hz, image_bytes) =
            link.receive(identity(|identity| (identity.messages, identity.counter_hz, identity.image_bytes as usize)))?;
        if messages != MESSAGES {
            let what = format!(
                "the image has other sensor values or commands ({messages:016x}, this program {MESSAGES:016x})"
            );
            return Err(super::error(what));
        }
        let instructions_per_tick = 1_000_000_000 / u64::from(counter_hz.max(1));
        Ok(Self { emulator, last_image_id: 0, instructions_per_tick, image_bytes, lease: None, last_request: 0 })
    }

    /// Returns the emulator.
    pub const fn emulator(&mut self) -> &mut Emulator {
        &mut self.emulator
    }

    /// Size of the largest camera image that the robot accepts, bytes.
    #[must_use]
    pub const fn image_bytes(&self) -> usize {
        self.image_bytes
    }

    /// Runs one sense-think-act cycle.
    ///
    /// # Errors
    /// If the emulator has ended, or the robot's command is invalid.
    pub fn cycle(&mut self, time_us: u64, sensors: &robot::Sensors<'_>) -> Result<CycleReport, Invalid> {
        let link = self.emulator.link();
        self.last_image_id = self.last_image_id.wrapping_add(u32::from(sensors.image.is_some()));
        let message = SensorsMessage::new(time_us, sensors, self.last_image_id);
        for part in message.chunks().chain([message.message()]) {
            link.send(&part)?;
        }
        let (of_us, command) = link.receive(|message| match message {
            FromRobot::Command(command) => Some((command.time_us, decode_command(&command))),
            _ => None,
        })?;
        if of_us != time_us {
            return Err(super::unexpected(format!("a command for {of_us} µs at {time_us} µs")));
        }
        let command = command?;
        let instructions_per_tick = self.instructions_per_tick;
        link.receive(|message| match message {
            FromRobot::Telemetry(telemetry) => Some(CycleReport::new(command, &telemetry, instructions_per_tick)),
            _ => None,
        })
    }

    /// Returns whether the image has a server for monitors, so that [`request`](Self::request) is possible.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn has_monitors(&mut self) -> Result<bool, Invalid> {
        self.send(&FromMonitor::Attach)?;
        // The answer to this message shows that the previous message was not answered.
        self.emulator.link().send(&ToRobot::StackUsage)?;
        let mut attached = false;
        self.emulator.link().receive(|message| {
            attached |= matches!(message, FromRobot::Monitor(_));
            matches!(message, FromRobot::StackUsage(_)).then_some(())
        })?;
        Ok(attached)
    }

    /// Requests a change before the next cycle, as the operator.
    ///
    /// # Errors
    /// If the emulator has ended, or the robot refuses the change.
    pub fn request(&mut self, change: Change) -> Result<(), Invalid> {
        let lease = match self.lease {
            Some(lease) => lease,
            None => self.acquire()?,
        };
        if change.is_stop(&Forward::GRAPH) {
            // A stop ends the lease in the image.
            self.lease = None;
        }
        self.last_request = self.last_request.wrapping_add(1);
        let number = self.last_request;
        self.send(&FromMonitor::Request(Request { number, lease, expires_us: u64::MAX, change }))?;
        let refusal = self.emulator.link().receive(|message| match answer(&message)? {
            ToMonitor::Answer(answer) if answer.number == number => Some(match answer.result {
                AnswerResult::Done { .. } => None,
                AnswerResult::Refused { text, .. } => Some(text.to_owned()),
            }),
            _ => None,
        })?;
        refusal.map_or(Ok(()), |text| Err(super::unexpected(format!("the robot refused a request: {text}"))))
    }

    /// Keeps the lease, if there is one. It must be called at least once in 3 s of the robot's time.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn keep(&mut self) -> Result<(), Invalid> {
        self.lease.map_or(Ok(()), |lease| self.send(&FromMonitor::Lease(LeaseAction::Keep { lease })))
    }

    fn acquire(&mut self) -> Result<u64, Invalid> {
        self.send(&FromMonitor::Lease(LeaseAction::Acquire))?;
        let lease = self.emulator.link().receive(|message| match answer(&message)? {
            ToMonitor::Lease(lease) if lease.yours => Some(lease.lease),
            _ => None,
        })?;
        self.lease = Some(lease);
        Ok(lease)
    }

    fn send(&mut self, message: &FromMonitor) -> Result<(), Invalid> {
        let mut buffer = [0; bica_wire::MAX_PACKET];
        let bytes = postcard::to_slice(message, &mut buffer);
        let bytes = bytes.map_err(super::unexpected)?;
        self.emulator.link().send(&ToRobot::Monitor(bytes))
    }

    /// Requests the stack usage.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn stack_usage(&mut self) -> Result<StackUsage, Invalid> {
        self.emulator.link().send(&ToRobot::StackUsage)?;
        self.emulator.link().receive(|message| match message {
            FromRobot::StackUsage(usage) => Some(usage),
            _ => None,
        })
    }
}

impl CycleReport {
    fn new(command: robot::Command, telemetry: &Telemetry<'_>, instructions_per_tick: u64) -> Self {
        let instructions = |ticks: u32| u64::from(ticks) * instructions_per_tick;
        Self {
            command,
            instructions: instructions(telemetry.chain_ticks),
            costs: telemetry.component_ticks().map(instructions).collect(),
            active: (0..telemetry.states.len()).map(|index| telemetry.active >> index & 1 == 1).collect(),
            states: telemetry.states.iter().map(|&state| (state != u8::MAX).then_some(state.into())).collect(),
            lost: telemetry.incomplete_images + telemetry.link.damaged + telemetry.link.missing,
        }
    }
}

/// Returns the bit patterns of all numbers of a command: equal only for commands that are equal bit for bit.
pub fn command_bits(command: &robot::Command) -> impl Iterator<Item = u32> {
    let Lights { chest, left_eye, right_eye } = command.lights;
    let lights = [chest, left_eye, right_eye].map(|Light(red, green, blue)| [red, green, blue]);
    let joints = command.targets.0.into_iter().chain(command.stiffness.0);
    joints.chain(lights.into_iter().flatten()).map(f32::to_bits).chain([command.camera as u32])
}

/// Decodes a message to the operator; `None` for other messages.
fn answer<'a>(message: &FromRobot<'a>) -> Option<ToMonitor<'a>> {
    let FromRobot::Monitor(bytes) = message else { return None };
    postcard::from_bytes(bytes).ok()
}

fn identity<T>(read: impl Fn(Identity<'_>) -> T) -> impl FnMut(FromRobot<'_>) -> Option<T> {
    move |message| match message {
        FromRobot::Identity(identity) => Some(read(identity)),
        _ => None,
    }
}
