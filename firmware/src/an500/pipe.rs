//! The link as a pipe: the emulator's own standard input and output, by semihosting (Arm, Semihosting for `AArch32`).
//!
//! QEMU's serial port takes a byte at a time, at a tenth of a millisecond each; an image would take seconds. This way
//! takes as much as there is at once, and the board's time stands still while it waits, so nothing that the host's
//! own time does can be felt. Bytes come at once, or no faster than over a line of [`LINE_RATE`].

use core::arch::asm;
use core::ffi::CStr;
use core::ptr;

const OPEN: usize = 1;
const WRITE: usize = 5;
const READ: usize = 6;
const EXIT: usize = 0x18;

const READ_BINARY: usize = 1;
const WRITE_BINARY: usize = 5;
const APPLICATION_EXIT: usize = 0x2_0026;

/// Bytes in a second of a line that brings 30 images in that time, and little else.
pub(super) const LINE_RATE: u64 = 30 * 40_000;

/// The emulator's `-device loader` puts a word here if the link is a pipe.
const JUMPER: usize = 0x203f_fffc;
/// That word if bytes come at once ("PIPE").
const AT_ONCE: u32 = 0x4550_4950;
/// That word if they come as over a line ("LINE").
const AS_BY_LINE: u32 = 0x454e_494c;

/// Where bytes come from or go to.
#[derive(Clone, Copy)]
pub(crate) struct Pipe(usize);

/// What the jumper says.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Wanted {
    /// The serial port.
    Serial,
    /// A pipe, bytes at once.
    AtOnce,
    /// A pipe, bytes as over a line.
    AsByLine,
}

/// What the link is.
pub(super) fn wanted() -> Wanted {
    // SAFETY: a word of the board's memory, beyond what the linker gives to the program.
    match unsafe { ptr::read_volatile(ptr::with_exposed_provenance::<u32>(JUMPER)) } {
        AT_ONCE => Wanted::AtOnce,
        AS_BY_LINE => Wanted::AsByLine,
        _ => Wanted::Serial,
    }
}

impl Pipe {
    /// What the host says.
    pub(super) fn input() -> Self {
        Self::open(c"/dev/stdin", READ_BINARY)
    }

    /// What the host hears.
    pub(super) fn output() -> Self {
        Self::open(c"/dev/stdout", WRITE_BINARY)
    }

    fn open(path: &CStr, mode: usize) -> Self {
        Self(call(OPEN, &[path.as_ptr().addr(), mode, path.count_bytes()]))
    }

    /// Waits for bytes. The end of the input is the end of the robot.
    pub(super) fn read(self, room: &mut [u8]) -> usize {
        match room.len() - call(READ, &[self.0, room.as_mut_ptr().expose_provenance(), room.len()]) {
            0 => exit(),
            count => count,
        }
    }

    /// Sends bytes.
    pub(super) fn write(self, bytes: &[u8]) {
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
    // SAFETY: every operation used here reads its block and what that points to; `READ` writes to a buffer that its
    // caller borrowed mutably.
    unsafe { asm!("bkpt 0xab", inout("r0") operation => result, in("r1") argument, options(nostack)) };
    result
}
