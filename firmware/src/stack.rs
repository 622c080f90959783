//! How deep the stack ever was: it is painted at the start, and the paint that is gone was used.
#![expect(unsafe_code, reason = "the stack's memory belongs to no variable")]

use core::arch::asm;
use core::ptr::{addr_of, addr_of_mut};

use bica_wire::message::StackUsage as Stack;

const PAINT: u32 = 0x5afe_57ac;

unsafe extern "C" {
    /// Where the stack begins: its highest address.
    static _stack_start: u32;
    /// Where it must not reach: the end of the static memory.
    static mut __euninit: u32;
}

/// Paints what is still unused.
#[inline(never)]
pub(crate) fn paint() {
    let here: u32;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) here, options(nomem, nostack)) };
    // SAFETY: the words from the end of the static memory to well below the stack pointer are nobody's.
    unsafe {
        let mut word = addr_of_mut!(__euninit);
        while word.addr() < here as usize - 64 {
            word.write_volatile(PAINT);
            word = word.add(1);
        }
    }
}

/// How much was used.
pub(crate) fn used() -> Stack {
    // SAFETY: the linker's symbols are only asked for their addresses, and each word read is the stack's memory.
    unsafe {
        let (top, mut word) = (addr_of!(_stack_start), addr_of!(__euninit));
        let room = (top.addr() - word.addr()) as u32;
        while word < top && word.read_volatile() == PAINT {
            word = word.add(1);
        }
        Stack { max_used: (top.addr() - word.addr()) as u32, size: room }
    }
}
