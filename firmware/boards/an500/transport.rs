//! The link: a serial port with a queue of received bytes, or a pipe.
#![expect(unsafe_code, reason = "an interrupt is enabled and handled by its number")]

use core::cell::RefCell;
use core::convert::Infallible;
use core::future::poll_fn;
use core::task::Poll;

use cortex_m::interrupt::InterruptNumber;
use cortex_m::peripheral::NVIC;
use cortex_m_rt::exception;
use critical_section::{CriticalSection, Mutex};
use embassy_sync::waitqueue::AtomicWaker;
use embassy_time::{Duration, Instant};
use embedded_io_async::{ErrorType, Read, Write};
use heapless::Deque;

use crate::pipe::{self, PACED_RATE, Pipe, Transport};
use crate::uart;

/// Capacity of the receive queue, bytes. While it is full, the port does not accept bytes from the host.
const QUEUE_BYTES: usize = 1024;

static QUEUE: Mutex<RefCell<Deque<u8, QUEUE_BYTES>>> = Mutex::new(RefCell::new(Deque::new()));
static WAKER: AtomicWaker = AtomicWaker::new();

/// The receive interrupt of the first port.
#[derive(Clone, Copy)]
struct UartRx0;

// SAFETY: number 0 is the interrupt `UARTRX0` of this board and is used for nothing else.
unsafe impl InterruptNumber for UartRx0 {
    fn number(self) -> u16 {
        0
    }
}

/// Enables the receive interrupt.
pub(crate) fn start() {
    uart::LINK.enable_interrupt(true);
    // SAFETY: the handler accesses shared state only in critical sections.
    unsafe { NVIC::unmask(UartRx0) };
}

/// Receiver from the host.
pub(crate) enum Rx {
    /// The serial port.
    Serial,
    /// A pipe.
    Pipe(Pipe),
    /// A pipe that delivers the next bytes at this time.
    PacedPipe(Pipe, Instant),
}

/// Transmitter to the host.
pub(crate) enum Tx {
    /// The serial port.
    Serial,
    /// A pipe.
    Pipe(Pipe),
}

/// Opens both directions of the selected transport.
pub(crate) fn open() -> (Rx, Tx) {
    match pipe::selected() {
        Transport::Serial => (Rx::Serial, Tx::Serial),
        Transport::Pipe => (Rx::Pipe(Pipe::input()), Tx::Pipe(Pipe::output())),
        Transport::PacedPipe => (Rx::PacedPipe(Pipe::input(), Instant::now()), Tx::Pipe(Pipe::output())),
    }
}

/// Sends bytes without tasks and interrupts.
pub(crate) fn write_blocking(bytes: &[u8]) {
    match pipe::selected() {
        Transport::Serial => uart::LINK.send(bytes),
        Transport::Pipe | Transport::PacedPipe => Pipe::output().write(bytes),
    }
}

impl ErrorType for Rx {
    type Error = Infallible;
}

impl ErrorType for Tx {
    type Error = Infallible;
}

impl Read for Rx {
    /// Waits for at least one byte, then returns all that are available.
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        match self {
            Self::Serial => Ok(receive(buffer).await),
            Self::Pipe(pipe) => Ok(pipe.read(buffer)),
            Self::PacedPipe(pipe, next) => {
                wait_until(*next).await;
                let count = pipe.read(buffer);
                *next += Duration::from_micros(count as u64 * 1_000_000 / PACED_RATE);
                Ok(count)
            }
        }
    }
}

impl Write for Tx {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        match self {
            Self::Serial => uart::LINK.send(bytes),
            Self::Pipe(pipe) => pipe.write(bytes),
        }
        Ok(bytes.len())
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Waits until a time.
///
/// The executor idles with `wfe`, which QEMU does not treat as sleep: time would pass only a few instructions at a time.
async fn wait_until(time: Instant) {
    poll_fn(|context| {
        if Instant::now() >= time {
            return Poll::Ready(());
        }
        cortex_m::asm::wfi();
        context.waker().wake_by_ref();
        Poll::Pending
    })
    .await;
}

/// Waits for bytes of the serial port and returns their number.
async fn receive(buffer: &mut [u8]) -> usize {
    let count = poll_fn(|context| {
        WAKER.register(context.waker());
        match dequeue(buffer) {
            0 => Poll::Pending,
            count => Poll::Ready(count),
        }
    });
    count.await
}

fn dequeue(buffer: &mut [u8]) -> usize {
    critical_section::with(|cs| {
        // A byte that was received while the interrupt was disabled causes no interrupt, so the port is read after the
        // interrupt is enabled. If nothing is returned, the port is empty, and the next byte wakes the task.
        uart::LINK.enable_interrupt(true);
        enqueue(cs);
        let mut queue = QUEUE.borrow_ref_mut(cs);
        let mut count = 0;
        while let Some((place, byte)) = buffer.get_mut(count).and_then(|place| Some((place, queue.pop_front()?))) {
            *place = byte;
            count += 1;
        }
        count
    })
}

/// Moves received bytes into the queue. Disables the interrupt if it is full: the port then stays full, and the host waits.
fn enqueue(cs: CriticalSection<'_>) {
    let mut queue = QUEUE.borrow_ref_mut(cs);
    uart::LINK.clear_interrupt();
    while !queue.is_full() {
        let Some(byte) = uart::LINK.receive() else { break };
        let _ = queue.push_back(byte);
    }
    if queue.is_full() {
        uart::LINK.enable_interrupt(false);
    }
}

// SAFETY: the handler of the receive interrupts, the only ones that are enabled. It accesses shared state only in critical sections.
#[exception]
unsafe fn DefaultHandler(_interrupt: i16) {
    critical_section::with(|cs| {
        enqueue(cs);
        #[cfg(feature = "monitor")]
        crate::monitor::enqueue(cs);
    });
    WAKER.wake();
}
