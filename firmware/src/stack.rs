//! Maximum use of the stack: it is filled with a pattern at the start; the changed part was used.
#![expect(unsafe_code, reason = "the memory of the stack belongs to no variable")]

use core::arch::asm;
use core::ptr::{addr_of, addr_of_mut};

use bica_wire::message::StackUsage;

const PATTERN: u32 = 0x5afe_57ac;

unsafe extern "C" {
    /// Start of the stack: its highest address.
    static _stack_start: u32;
    /// End of the static memory: the stack's lowest address.
    static mut __euninit: u32;
}

/// Fills the unused part of the stack with a pattern.
#[inline(never)]
pub(crate) fn paint() {
    let stack_pointer: u32;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) stack_pointer, options(nomem, nostack)) };
    // SAFETY: no variable lies in the words from the end of the static memory to 64 bytes below the stack pointer.
    unsafe {
        let mut word = addr_of_mut!(__euninit);
        while word.addr() < stack_pointer as usize - 64 {
            word.write_volatile(PATTERN);
            word = word.add(1);
        }
    }
}

/// Returns the maximum use since [`paint`].
pub(crate) fn usage() -> StackUsage {
    // SAFETY: of the linker's symbols only the addresses are used, and each word read belongs to the stack.
    unsafe {
        let (top, mut word) = (addr_of!(_stack_start), addr_of!(__euninit));
        let size = (top.addr() - word.addr()) as u32;
        while word < top && word.read_volatile() == PATTERN {
            word = word.add(1);
        }
        StackUsage { max_used: (top.addr() - word.addr()) as u32, size }
    }
}
