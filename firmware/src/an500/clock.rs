//! The time, by the processor's own timer.

use core::cell::{Cell, RefCell};
use core::task::Waker;

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{SCB, SYST};
use cortex_m_rt::exception;
use critical_section::{CriticalSection, Mutex};
use embassy_time_driver::Driver;
use embassy_time_queue_utils::Queue;

/// The processor's clock.
pub(super) const HZ: u32 = 25_000_000;
/// The timer's clock ticks between two interrupts: 1 ms, the grain of alarms.
const PERIOD: u32 = HZ / 1000;
const PER_MICROSECOND: u64 = (HZ / 1_000_000) as u64;

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
pub(super) fn start() {
    critical_section::with(|_| {
        // SAFETY: nobody else has the timer; it is this module's alone.
        let mut timer = unsafe { cortex_m::Peripherals::steal() }.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(PERIOD - 1);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
    });
}

/// Clock ticks since the start.
pub(super) fn fine() -> u64 {
    critical_section::with(|cs| CLOCK.fine(cs))
}

/// Begins a new period of the timer now, so that whatever follows finds the timer in the same phase.
pub(super) fn settle() {
    critical_section::with(|cs| {
        let now = CLOCK.fine(cs);
        CLOCK.base.borrow(cs).set(now);
        // SAFETY: nobody else has the timer; interrupts are off.
        unsafe { cortex_m::Peripherals::steal() }.SYST.clear_current();
        SCB::clear_pendst();
    });
}

impl Clock {
    fn fine(&self, cs: CriticalSection<'_>) -> u64 {
        let mut left = SYST::get_current();
        let mut base = self.base.borrow(cs).get();
        if SCB::is_pendst_pending() {
            left = SYST::get_current();
            base += u64::from(PERIOD);
        }
        base + u64::from(if left == 0 { 0 } else { PERIOD - left })
    }

    fn now(&self, cs: CriticalSection<'_>) -> u64 {
        self.fine(cs) / PER_MICROSECOND
    }

    /// A period is over: wakes whoever waited for it.
    fn tick(&self, cs: CriticalSection<'_>) {
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
    critical_section::with(|cs| CLOCK.tick(cs));
}
