//! The log: defmt's bytes are sent through the second serial port.
#![expect(unsafe_code, reason = "the logger's state is shared by critical sections that defmt acquires and releases")]

use core::cell::UnsafeCell;

use critical_section::RestoreState;
use defmt::Encoder;

use crate::uart;

struct State(UnsafeCell<(Encoder, RestoreState)>);

// SAFETY: every access happens between `acquire` and `release`, in a critical section on the only core.
unsafe impl Sync for State {}

static STATE: State = State(UnsafeCell::new((Encoder::new(), RestoreState::invalid())));

#[defmt::global_logger]
struct Log;

// SAFETY: interrupts are off from `acquire` to `release` on the only core, so no other context logs, and defmt never
// acquires twice in one context.
unsafe impl defmt::Logger for Log {
    fn acquire() {
        // SAFETY: `release` restores the state.
        let restore = unsafe { critical_section::acquire() };
        // SAFETY: interrupts are off, so this is the only access to the state.
        let (encoder, saved) = unsafe { &mut *STATE.0.get() };
        *saved = restore;
        encoder.start_frame(send);
    }

    unsafe fn flush() {}

    unsafe fn release() {
        // SAFETY: as in `acquire`.
        let (encoder, saved) = unsafe { &mut *STATE.0.get() };
        encoder.end_frame(send);
        // SAFETY: the state that `acquire` saved.
        unsafe { critical_section::release(*saved) };
    }

    unsafe fn write(bytes: &[u8]) {
        // SAFETY: as in `acquire`.
        let (encoder, _) = unsafe { &mut *STATE.0.get() };
        encoder.write(bytes, send);
    }
}

fn send(bytes: &[u8]) {
    uart::LOG.send(bytes);
}

defmt::timestamp!("{=u64:us}", embassy_time_driver::now());
