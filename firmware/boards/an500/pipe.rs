//! The link as a pipe: the emulator's standard input and output, by semihosting (Arm, Semihosting for `AArch32`).
//!
//! QEMU's serial port transfers one byte per call, about 0.1 ms each, so an image would take seconds. The pipe transfers
//! all available bytes at once. The board's time stands still while it waits, so the host's timing has no effect. A paced
//! pipe is limited to [`PACED_RATE`].
#![expect(unsafe_code, reason = "semihosting calls and a word beyond the program's memory")]

use core::arch::asm;
use core::ffi::CStr;
use core::ptr;

/// Semihosting operations.
const OPEN: usize = 1;
const WRITE: usize = 5;
const READ: usize = 6;
const EXIT: usize = 0x18;

/// Modes of `OPEN`, and reason of `EXIT`.
const READ_BINARY: usize = 1;
const WRITE_BINARY: usize = 5;
const APPLICATION_EXIT: usize = 0x2_0026;

/// Rate of the paced pipe, bytes per second: 30 images and little else.
pub(crate) const PACED_RATE: u64 = 30 * 40_000;

/// Address of the word by which QEMU's `-device loader` selects the transport.
const SELECTOR: usize = 0x203f_fffc;
/// Value of that word for the pipe: "PIPE" in ASCII.
const SELECT_PIPE: u32 = 0x4550_4950;
/// Value of that word for the paced pipe: "LINE" in ASCII.
const SELECT_PACED_PIPE: u32 = 0x454e_494c;

/// One direction of a pipe, by its semihosting handle.
#[derive(Clone, Copy)]
pub(crate) struct Pipe(usize);

/// Transport of the link.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Transport {
    /// The serial port.
    Serial,
    /// A pipe of unlimited rate.
    Pipe,
    /// A pipe of limited rate.
    PacedPipe,
}

/// Returns the selected transport.
pub(crate) fn selected() -> Transport {
    // SAFETY: a word of the board's memory outside the memory that the linker gives to the program.
    match unsafe { ptr::read_volatile(ptr::with_exposed_provenance::<u32>(SELECTOR)) } {
        SELECT_PIPE => Transport::Pipe,
        SELECT_PACED_PIPE => Transport::PacedPipe,
        _ => Transport::Serial,
    }
}

impl Pipe {
    /// Opens the direction from the host.
    pub(crate) fn input() -> Self {
        Self::open(c"/dev/stdin", READ_BINARY)
    }

    /// Opens the direction to the host.
    pub(crate) fn output() -> Self {
        Self::open(c"/dev/stdout", WRITE_BINARY)
    }

    fn open(path: &CStr, mode: usize) -> Self {
        Self(call(OPEN, &[path.as_ptr().addr(), mode, path.count_bytes()]))
    }

    /// Waits for bytes and returns their number. The end of the input ends the program.
    pub(crate) fn read(self, buffer: &mut [u8]) -> usize {
        match buffer.len() - call(READ, &[self.0, buffer.as_mut_ptr().expose_provenance(), buffer.len()]) {
            0 => exit(),
            count => count,
        }
    }

    /// Sends bytes.
    pub(crate) fn write(self, bytes: &[u8]) {
        call(WRITE, &[self.0, bytes.as_ptr().expose_provenance(), bytes.len()]);
    }
}

fn exit() -> ! {
    loop {
        call_with(EXIT, APPLICATION_EXIT);
    }
}

fn call(operation: usize, block: &[usize; 3]) -> usize {
    call_with(operation, block.as_ptr().expose_provenance())
}

fn call_with(operation: usize, argument: usize) -> usize {
    let result;
    // SAFETY: each operation used here reads its argument block and the memory that it points to; `READ` writes to a
    // buffer that its caller has borrowed mutably.
    unsafe { asm!("bkpt 0xab", inout("r0") operation => result, in("r1") argument, options(nostack)) };
    result
}
