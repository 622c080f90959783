//! The interface of a board.

use embedded_io_async::{Read, Write};

/// A board that runs the robot's controller.
///
/// A board also provides a time driver with 1 µs ticks (`embassy_time_driver::time_driver_impl!`) and a log
/// (`#[defmt::global_logger]`), which the linker finds. Most HALs contain both.
///
/// If another computer owns cameras and joints, they are accessed over the link. A board that owns them provides an
/// [`Rx`](Self::Rx) that encodes [`bica_wire::ToRobot`] packets from their values, and a [`Tx`](Self::Tx) that executes
/// the [`bica_wire::FromRobot::Command`]s written to it.
///
/// # Images
///
/// With the feature `medium-frames` there is memory for one image. The tree has no image from the first chunk of an image until the
/// [`bica_wire::ToRobot::Sensors`] message that completes it: a detector that is due in this interval keeps its result, and
/// processes the next complete image. In lockstep no cycle runs in this interval. In free-running mode a body
///
/// - sends all chunks of an image and its sensor values within one cycle, 10 ms, or
/// - waits for 40 ms, the longest time until each detector has run, before it sends the next image, or
/// - starts the camera's transfer when the detectors have run, if the board owns the camera.
///
/// Otherwise detectors miss images, but never process an incomplete one. An image with a missing chunk is counted, and the tree has
/// no image until the next complete one. Without the feature the tree keeps the previous image in a second memory.
pub trait Board: Sized {
    /// Receiver of bytes: a serial line, a TCP connection or any other ordered stream. Bytes may get lost.
    type Rx: Read;
    /// Transmitter of bytes.
    type Tx: Write;
    /// Receiver of bytes on the line for monitors. If its `read` is dropped before it is ready, no byte may be lost.
    /// [`NoLine`](crate::NoLine) on a board without such a line, and in an image without the feature `monitor`.
    type MonitorRx: Read;
    /// Transmitter of bytes on the line for monitors. If its `write` is dropped before it is ready, nothing may be written.
    type MonitorTx: Write;
    /// Rate of [`Self::counter`], Hz.
    const COUNTER_HZ: u32;

    /// Returns the lines.
    fn links(self) -> Links<Self>;

    /// Returns a counter that measures the cost of code. It wraps around.
    fn counter() -> u32;

    /// Called before a measurement that must be reproducible: aligns the phase of the counter, where a board can choose
    /// it. A counter of processor cycles needs no alignment.
    fn align_counter() {}

    /// Sends bytes and waits until the hardware has sent them. Called after a panic, when tasks no longer run.
    fn write_blocking(bytes: &[u8]);

    /// Restarts the microcontroller. Memory in `.uninit` sections keeps its content.
    fn reset() -> !;
}

/// The lines of a board, both directions of each.
pub struct Links<B: Board> {
    /// The line to the body.
    pub body: (B::Rx, B::Tx),
    /// The line for monitors.
    pub monitor: (B::MonitorRx, B::MonitorTx),
}
