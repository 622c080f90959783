//! Time driver with the processor's own timer, `SysTick`.
#![expect(unsafe_code, reason = "the timer is accessed without its owner")]

use core::cell::{Cell, RefCell};
use core::task::Waker;

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{SCB, SYST};
use cortex_m_rt::exception;
use critical_section::{CriticalSection, Mutex};
use embassy_time_driver::Driver;
use embassy_time_queue_utils::Queue;

/// Frequency of the processor's clock, Hz.
pub(crate) const HZ: u32 = 25_000_000;
/// Clock ticks between two timer interrupts: 1 ms, the resolution of alarms.
const PERIOD: u32 = HZ / 1000;
const TICKS_PER_MICROSECOND: u64 = (HZ / 1_000_000) as u64;

struct Clock {
    /// Clock ticks up to the last interrupt.
    base: Mutex<Cell<u64>>,
    queue: Mutex<RefCell<Queue>>,
}

embassy_time_driver::time_driver_impl!(static CLOCK: Clock = Clock {
    base: Mutex::new(Cell::new(0)),
    queue: Mutex::new(RefCell::new(Queue::new())),
});

/// Starts the timer.
pub(crate) fn start() {
    critical_section::with(|_| {
        // SAFETY: only this module accesses the timer.
        let mut timer = unsafe { cortex_m::Peripherals::steal() }.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(PERIOD - 1);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
    });
}

/// Returns the clock ticks since the start.
pub(crate) fn counter() -> u64 {
    critical_section::with(|cs| CLOCK.counter(cs))
}

/// Starts a new timer period now, so that the code that follows always finds the timer in the same phase.
pub(crate) fn align() {
    critical_section::with(|cs| {
        let now = CLOCK.counter(cs);
        CLOCK.base.borrow(cs).set(now);
        // SAFETY: only this module accesses the timer, and interrupts are off.
        unsafe { cortex_m::Peripherals::steal() }.SYST.clear_current();
        SCB::clear_pendst();
    });
}

impl Clock {
    fn counter(&self, cs: CriticalSection<'_>) -> u64 {
        let mut remaining = SYST::get_current();
        let mut base = self.base.borrow(cs).get();
        if SCB::is_pendst_pending() {
            remaining = SYST::get_current();
            base += u64::from(PERIOD);
        }
        base + u64::from(if remaining == 0 { 0 } else { PERIOD - remaining })
    }

    fn now(&self, cs: CriticalSection<'_>) -> u64 {
        self.counter(cs) / TICKS_PER_MICROSECOND
    }

    /// Ends a timer period and wakes the tasks whose alarm has expired.
    fn end_period(&self, cs: CriticalSection<'_>) {
        let base = self.base.borrow(cs);
        base.set(base.get() + u64::from(PERIOD));
        self.queue.borrow_ref_mut(cs).next_expiration(self.now(cs));
    }
}

impl Driver for Clock {
    fn now(&self) -> u64 {
        critical_section::with(|cs| self.now(cs))
    }

    fn schedule_wake(&self, at: u64, waker: &Waker) {
        critical_section::with(|cs| self.queue.borrow_ref_mut(cs).schedule_wake(at, waker));
    }
}

#[exception]
fn SysTick() {
    critical_section::with(|cs| CLOCK.end_period(cs));
}
