//! The board's serial ports (Arm, Cortex-M System Design Kit, APB UART).
#![expect(unsafe_code, reason = "registers are accessed by address")]

use core::ptr;

/// The first port: the link.
pub(crate) const LINK: Uart = Uart(0x4000_4000);
/// The second port: the log.
pub(crate) const LOG: Uart = Uart(0x4000_5000);
/// The third port: monitors.
#[cfg(feature = "monitor")]
pub(crate) const MONITOR: Uart = Uart(0x4000_6000);

/// Offsets of the registers, bytes.
const DATA: usize = 0;
const STATE: usize = 4;
const CONTROL: usize = 8;
const INTERRUPT_CLEAR: usize = 12;
const BAUD_DIVIDER: usize = 16;

/// Bits of the state register.
const TX_FULL: u32 = 1;
const RX_FULL: u32 = 2;
/// Bits of the control register.
const TX_ENABLE: u32 = 1;
const RX_ENABLE: u32 = 2;
const RX_INTERRUPT_ENABLE: u32 = 8;
/// Bit of the receive interrupt.
const RX_INTERRUPT: u32 = 2;

/// A port, by the address of its first register.
#[derive(Clone, Copy)]
pub(crate) struct Uart(usize);

impl Uart {
    /// Enables both directions.
    pub(crate) fn start(self) {
        self.write(BAUD_DIVIDER, 16);
        self.write(CONTROL, TX_ENABLE | RX_ENABLE);
    }

    /// Enables or disables the receive interrupt.
    pub(crate) fn enable_interrupt(self, enable: bool) {
        self.write(CONTROL, TX_ENABLE | RX_ENABLE | if enable { RX_INTERRUPT_ENABLE } else { 0 });
    }

    /// Clears the receive interrupt.
    pub(crate) fn clear_interrupt(self) {
        self.write(INTERRUPT_CLEAR, RX_INTERRUPT);
    }

    /// Sends bytes and waits until each is taken.
    pub(crate) fn send(self, bytes: &[u8]) {
        for &byte in bytes {
            while self.read(STATE) & TX_FULL != 0 {}
            self.write(DATA, byte.into());
        }
    }

    /// Sends a byte, if the port can take it; returns whether it did.
    #[cfg(feature = "monitor")]
    pub(crate) fn try_send(self, byte: u8) -> bool {
        let is_free = self.read(STATE) & TX_FULL == 0;
        if is_free {
            self.write(DATA, byte.into());
        }
        is_free
    }

    /// Returns the received byte, if there is one.
    pub(crate) fn receive(self) -> Option<u8> {
        (self.read(STATE) & RX_FULL != 0).then(|| self.read(DATA) as u8)
    }

    fn read(self, register: usize) -> u32 {
        // SAFETY: this board has the ports of this module, every register is a readable word, and a read changes no
        // memory of the program.
        unsafe { ptr::read_volatile(ptr::with_exposed_provenance(self.0 + register)) }
    }

    fn write(self, register: usize, value: u32) {
        // SAFETY: as in `read`; the ports cannot access the program's memory.
        unsafe { ptr::write_volatile(ptr::with_exposed_provenance_mut(self.0 + register), value) }
    }
}
