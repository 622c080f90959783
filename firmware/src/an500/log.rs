//! The log: defmt's bytes go out through the second port.

use core::cell::UnsafeCell;

use critical_section::RestoreState;
use defmt::Encoder;

use super::uart;

struct State(UnsafeCell<(Encoder, RestoreState)>);

// SAFETY: whoever touches it holds a critical section on the only core, from `acquire` to `release`.
unsafe impl Sync for State {}

static STATE: State = State(UnsafeCell::new((Encoder::new(), RestoreState::invalid())));

#[defmt::global_logger]
struct Log;

// SAFETY: from `acquire` to `release` interrupts are off on the only core, so no other context logs, and defmt itself
// never acquires twice in one.
unsafe impl defmt::Logger for Log {
    fn acquire() {
        // SAFETY: `release` gives the state back.
        let restore = unsafe { critical_section::acquire() };
        // SAFETY: interrupts are off; nobody else has the state.
        let (encoder, kept) = unsafe { &mut *STATE.0.get() };
        *kept = restore;
        encoder.start_frame(send);
    }

    unsafe fn flush() {}

    unsafe fn release() {
        // SAFETY: as in `acquire`.
        let (encoder, kept) = unsafe { &mut *STATE.0.get() };
        encoder.end_frame(send);
        // SAFETY: the state that `acquire` got.
        unsafe { critical_section::release(*kept) };
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
