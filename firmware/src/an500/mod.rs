//! The board `mps2-an500` as QEMU has it: a Cortex-M7 at 25 MHz.
//!
//! With `-icount shift=0` an instruction takes one nanosecond, so the 25 MHz clock ticks once in 40 instructions.
#![expect(unsafe_code, reason = "registers and pipes are reached by their addresses")]

mod clock;
mod line;
mod log;
mod pipe;
mod uart;

use cortex_m::peripheral::SCB;

use crate::board::Board;
pub(crate) use line::{Ear, Mouth};

/// The board.
pub(crate) struct An500(());

impl An500 {
    /// Switches the board's parts on. Called once.
    pub(crate) fn start() -> Self {
        clock::start();
        uart::LOG.start();
        uart::LINK.start();
        line::start();
        Self(())
    }
}

impl Board for An500 {
    type Ear = Ear;
    type Mouth = Mouth;
    const FINE_HZ: u32 = clock::HZ;

    fn link(self) -> (Ear, Mouth) {
        line::open()
    }

    fn fine() -> u32 {
        clock::fine() as u32
    }

    fn settle() {
        clock::settle();
    }

    fn cry(bytes: &[u8]) {
        line::cry(bytes);
    }

    fn reset() -> ! {
        SCB::sys_reset()
    }
}
