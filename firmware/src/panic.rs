//! Reaction to a panic.

use core::fmt::Display;

use bica_motion::joints::Joints;
use bica_motion::robot::{CameraId, Command, Lights};
use bica_wire::Encoder;

use crate::board::Board;
use crate::crash_log;
use crate::link::encode_command;

/// Size of a buffer that holds the packet of a command: a message of at most 250 bytes, and the overhead of COBS.
const COMMAND_PACKET: usize = 320;

/// Switches all joints off, stores the panic's message in the crash log, and restarts the microcontroller.
pub fn handle_panic<B: Board>(message: impl Display) -> ! {
    cortex_m::interrupt::disable();
    let off = Command {
        targets: Joints::all(0.0),
        stiffness: Joints::all(0.0),
        lights: Lights::default(),
        camera: CameraId::default(),
    };
    let mut buffer = [0; COMMAND_PACKET];
    // A zero byte terminates a packet that the panic may have interrupted.
    B::write_blocking(&[0]);
    if let Some(length) = encode_command(u64::MAX, &off, &mut Encoder::new(), &mut buffer) {
        B::write_blocking(&buffer[..length]);
    }
    crash_log::write(message);
    B::reset()
}
