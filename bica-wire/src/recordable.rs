//! Robots whose sensor values and commands can be encoded.

use bica_runner::Robot;
use postcard_schema::Schema;
use postcard_schema::key::Key;
use postcard_schema::schema::NamedType;
use serde::{Deserialize, Serialize};

use crate::blobs;

/// Robot whose sensor values and commands can be encoded, and so recorded, replayed and sent.
///
/// Every [`Robot`] whose types `Sensors` and `Command` have the attribute `#[data]` is one.
#[diagnostic::on_unimplemented(
    message = "the sensor values or the command of `{Self}` cannot be recorded, replayed and sent",
    label = "its type `Sensors` or `Command` cannot be encoded",
    note = "write `#[data]` before both structs or enums, and before each one of your own that they hold"
)]
pub trait Recordable: Robot {
    /// Schema of the sensor values.
    const SENSORS: &'static NamedType;
    /// Schema of the command.
    const COMMAND: &'static NamedType;

    /// Encodes sensor values at the end of `out`; `take` receives their blobs: see [`blobs::encode`].
    fn encode_sensors<E: Extend<u8>>(sensors: &Self::Sensors<'_>, out: E, take: impl FnMut(usize, &[u8])) -> Option<E>;

    /// Decodes sensor values: see [`blobs::decode`].
    fn decode_sensors<'a>(message: &'a [u8], blobs: &'a [u8]) -> Option<Self::Sensors<'a>>;

    /// Encodes a command at the end of `out`, with all its data.
    fn encode_command<E: Extend<u8>>(command: &Self::Command, out: E) -> Option<E>;
}

#[diagnostic::do_not_recommend]
impl<R: Robot> Recordable for R
where
    for<'a> R::Sensors<'a>: Serialize + Deserialize<'a> + Schema,
    R::Command: Serialize + Schema,
{
    const SENSORS: &'static NamedType = <R::Sensors<'static> as Schema>::SCHEMA;
    const COMMAND: &'static NamedType = <R::Command as Schema>::SCHEMA;

    fn encode_sensors<E: Extend<u8>>(sensors: &R::Sensors<'_>, out: E, take: impl FnMut(usize, &[u8])) -> Option<E> {
        blobs::encode(sensors, out, take)
    }

    fn decode_sensors<'a>(message: &'a [u8], blobs: &'a [u8]) -> Option<R::Sensors<'a>> {
        blobs::decode(message, blobs)
    }

    fn encode_command<E: Extend<u8>>(command: &R::Command, out: E) -> Option<E> {
        postcard::to_extend(command, out).ok()
    }
}

/// Hash of the schemas of a robot's sensor values and command. Two programs exchange them only if it is the same in both.
#[must_use]
pub const fn messages_hash<S: Schema, C: Schema>() -> u64 {
    let sensors = u64::from_le_bytes(Key::for_path::<S>("sensors").to_bytes());
    sensors ^ u64::from_le_bytes(Key::for_path::<C>("command").to_bytes()).rotate_left(1)
}
