//! What a board has to provide: the whole of a port.
//!
//! `docs/firmware-port.md` goes through it step by step. Besides what stands here a board brings two things that Rust
//! finds by themselves: a time driver (`embassy_time_driver::time_driver_impl!`, 1 µs ticks) and a log
//! (`#[defmt::global_logger]`); most have both in a crate already.

use embedded_io_async::{Read, Write};

/// A board that a robot's mind runs on.
///
/// Camera and joints are reached over the link, where another computer owns them. A board that owns them itself gives
/// an [`Ear`](Self::Ear) that makes [`bica_wire::ToRobot`] packets of what they give, and a [`Mouth`](Self::Mouth) that
/// obeys the [`bica_wire::FromRobot::Command`]s written to it.
pub(crate) trait Board: Sized {
    /// Where bytes come in: of a serial line, a TCP connection or whatever else keeps their order. Some may get lost.
    type Ear: Read;
    /// Where bytes go out.
    type Mouth: Write;
    /// How fast [`Self::fine`] counts, 1/s.
    const FINE_HZ: u32;

    /// The link.
    fn link(self) -> (Self::Ear, Self::Mouth);

    /// A clock to measure code with; wraps around.
    fn fine() -> u32;

    /// Called before a measurement that has to be the same in every run: whatever of the clock's phase can be chosen,
    /// is. A board with a counter of cycles has nothing to do here.
    fn settle() {}

    /// Sends bytes at once, waiting for the hardware; for last words. Nothing else runs any more.
    fn cry(bytes: &[u8]);

    /// Starts anew. Memory in `.uninit` sections keeps its content.
    fn reset() -> !;
}
