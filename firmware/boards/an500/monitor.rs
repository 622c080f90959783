//! The line for monitors: the third serial port, with a queue of received bytes.
#![expect(unsafe_code, reason = "an interrupt is enabled by its number")]

use core::cell::RefCell;
use core::convert::Infallible;
use core::future::poll_fn;
use core::task::Poll;

use cortex_m::interrupt::InterruptNumber;
use cortex_m::peripheral::NVIC;
use critical_section::{CriticalSection, Mutex};
use embedded_io_async::{ErrorType, Read, Write};
use heapless::Deque;

use crate::uart;

/// Capacity of the receive queue, bytes. While it is full, the port does not accept bytes from the host.
const QUEUE_BYTES: usize = 256;

static QUEUE: Mutex<RefCell<Deque<u8, QUEUE_BYTES>>> = Mutex::new(RefCell::new(Deque::new()));

/// The receive interrupt of the third port.
#[derive(Clone, Copy)]
struct UartRx2;

// SAFETY: number 4 is the interrupt `UARTRX2` of this board and is used for nothing else.
unsafe impl InterruptNumber for UartRx2 {
    fn number(self) -> u16 {
        4
    }
}

/// Enables the port and its receive interrupt.
pub(crate) fn start() {
    uart::MONITOR.start();
    uart::MONITOR.enable_interrupt(true);
    // SAFETY: the handler accesses shared state only in critical sections.
    unsafe { NVIC::unmask(UartRx2) };
}

/// Receiver from a monitor.
pub(crate) struct MonitorRx(());

/// Transmitter to a monitor.
pub(crate) struct MonitorTx(());

/// Returns both directions.
pub(crate) const fn open() -> (MonitorRx, MonitorTx) {
    (MonitorRx(()), MonitorTx(()))
}

/// Moves received bytes into the queue. Called by the interrupt handler.
pub(crate) fn enqueue(cs: CriticalSection<'_>) {
    let mut queue = QUEUE.borrow_ref_mut(cs);
    uart::MONITOR.clear_interrupt();
    while !queue.is_full() {
        let Some(byte) = uart::MONITOR.receive() else { break };
        let _ = queue.push_back(byte);
    }
    if queue.is_full() {
        uart::MONITOR.enable_interrupt(false);
    }
}

impl ErrorType for MonitorRx {
    type Error = Infallible;
}

impl ErrorType for MonitorTx {
    type Error = Infallible;
}

impl Read for MonitorRx {
    /// Returns the bytes that are available. This port wakes no task: it is polled.
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        let read = poll_fn(|_| match dequeue(buffer) {
            0 => Poll::Pending,
            count => Poll::Ready(Ok(count)),
        });
        read.await
    }
}

impl Write for MonitorTx {
    /// Writes the bytes that the port accepts. This port wakes no task: it is polled.
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let write = poll_fn(|_| match bytes.iter().take_while(|byte| uart::MONITOR.try_send(**byte)).count() {
            0 => Poll::Pending,
            count => Poll::Ready(Ok(count)),
        });
        write.await
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

fn dequeue(buffer: &mut [u8]) -> usize {
    critical_section::with(|cs| {
        // A byte that was received while the interrupt was disabled causes no interrupt.
        enqueue(cs);
        let mut queue = QUEUE.borrow_ref_mut(cs);
        let mut count = 0;
        while let Some((place, byte)) = buffer.get_mut(count).and_then(|place| Some((place, queue.pop_front()?))) {
            *place = byte;
            count += 1;
        }
        uart::MONITOR.enable_interrupt(true);
        count
    })
}
