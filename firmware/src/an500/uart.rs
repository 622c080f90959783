//! The board's serial ports (Arm, Cortex-M System Design Kit, APB UART).

use core::ptr;

/// The first port: the link.
pub(super) const LINK: Uart = Uart(0x4000_4000);
/// The second port: the log.
pub(super) const LOG: Uart = Uart(0x4000_5000);

const STATE: usize = 4;
const CONTROL: usize = 8;
const INTERRUPT: usize = 12;
const DIVIDER: usize = 16;

const SEND_FULL: u32 = 1;
const HEARD: u32 = 2;
const SEND: u32 = 1;
const HEAR: u32 = 2;
const HEAR_INTERRUPT: u32 = 8;

/// A port, by the address of its first register.
#[derive(Clone, Copy)]
pub(super) struct Uart(usize);

impl Uart {
    /// Sends and hears from now on.
    pub(super) fn start(self) {
        self.write(DIVIDER, 16);
        self.write(CONTROL, SEND | HEAR);
    }

    /// Lets heard bytes interrupt, or not.
    pub(super) fn interrupt(self, wanted: bool) {
        self.write(CONTROL, SEND | HEAR | if wanted { HEAR_INTERRUPT } else { 0 });
    }

    /// Notes that the interrupt was seen.
    pub(super) fn seen(self) {
        self.write(INTERRUPT, HEAR);
    }

    /// Sends bytes, waiting for each to go.
    pub(super) fn send(self, bytes: &[u8]) {
        for &byte in bytes {
            while self.read(STATE) & SEND_FULL != 0 {}
            self.write(0, byte.into());
        }
    }

    /// The next byte heard, if there is one.
    pub(super) fn hear(self) -> Option<u8> {
        (self.read(STATE) & HEARD != 0).then(|| self.read(0) as u8)
    }

    fn read(self, register: usize) -> u32 {
        // SAFETY: both ports of this module are there on this board, every register is a readable word, and reading
        // one touches no memory of the program.
        unsafe { ptr::read_volatile(ptr::with_exposed_provenance(self.0 + register)) }
    }

    fn write(self, register: usize, value: u32) {
        // SAFETY: as for `read`; the ports have no access to the program's memory.
        unsafe { ptr::write_volatile(ptr::with_exposed_provenance_mut(self.0 + register), value) }
    }
}
