//! The board mps2-an500 as QEMU emulates it: a Cortex-M7 at 25 MHz.
//!
//! With QEMU's option `-icount shift=0` an instruction takes one nanosecond, so the 25 MHz clock ticks once per 40 instructions.

use bica_firmware::{Board, Links};
use cortex_m::peripheral::SCB;

use crate::monitor::{self, MonitorRx, MonitorTx};
use crate::transport::{self, Rx, Tx};
use crate::{clock, uart};

/// The board.
pub(crate) struct An500(());

impl An500 {
    /// Starts the board's peripherals. Called once.
    pub(crate) fn start() -> Self {
        clock::start();
        uart::LOG.start();
        uart::LINK.start();
        transport::start();
        monitor::start();
        Self(())
    }
}

impl Board for An500 {
    type Rx = Rx;
    type Tx = Tx;
    type MonitorRx = MonitorRx;
    type MonitorTx = MonitorTx;
    const COUNTER_HZ: u32 = clock::HZ;

    fn links(self) -> Links<Self> {
        Links { body: transport::open(), monitor: monitor::open() }
    }

    fn counter() -> u32 {
        clock::counter() as u32
    }

    fn align_counter() {
        clock::align();
    }

    fn write_blocking(bytes: &[u8]) {
        transport::write_blocking(bytes);
    }

    fn reset() -> ! {
        SCB::sys_reset()
    }
}
