//! Sensor values and commands of a humanoid as messages.

use bica_motion::robot::{Command, Sensors};
use bica_wire::message::{self, BlobsInfo};
use bica_wire::model::Invalid;
use bica_wire::{ToRobot, blobs, chunks, messages_hash};

/// Hash of the schemas of a humanoid's sensor values and command.
pub const MESSAGES: u64 = messages_hash::<Sensors<'static>, Command>();

/// Encoded sensor values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SensorsMessage {
    /// Time of measurement, µs.
    pub time_us: u64,
    id: u32,
    values: Vec<u8>,
    image: Vec<u8>,
}

impl SensorsMessage {
    /// Encodes sensor values measured at a time, µs, with a number for their image.
    #[must_use]
    pub fn new(time_us: u64, sensors: &Sensors<'_>, id: u32) -> Self {
        let mut image = Vec::new();
        // Sensor values contain no type that postcard rejects.
        let values = blobs::encode(sensors, Vec::new(), |_, bytes| image.extend_from_slice(bytes)).unwrap_or_default();
        Self { time_us, id, values, image }
    }

    /// Returns the same values with another number for their image.
    #[must_use]
    pub fn numbered(self, id: u32) -> Self {
        Self { id, ..self }
    }

    /// Returns the chunks of the image, which are sent before the message.
    pub fn chunks(&self) -> impl Iterator<Item = ToRobot<'_>> {
        chunks(self.id, &self.image).map(ToRobot::ImageChunk)
    }

    /// Returns the message.
    #[must_use]
    pub fn message(&self) -> ToRobot<'_> {
        let blobs = (!self.image.is_empty()).then_some(BlobsInfo { id: self.id, bytes: self.image.len() as u32 });
        ToRobot::Sensors(message::Sensors { time_us: self.time_us, blobs, values: &self.values })
    }
}

/// Decodes a command.
///
/// # Errors
/// If the command cannot be decoded, or contains a value that is not finite or out of range.
pub fn decode_command(message: &message::Command<'_>) -> Result<Command, Invalid> {
    let command: Option<Command> = blobs::decode(message.values, &[]);
    let command = command.ok_or_else(|| super::unexpected("a command that cannot be read"))?;
    command.check().map_err(super::unexpected)?;
    Ok(command)
}
