//! The link: a serial port whose bytes wait in a queue until somebody asks for them, or a pipe.

use core::cell::RefCell;
use core::convert::Infallible;
use core::future::poll_fn;
use core::task::Poll;

use cortex_m::interrupt::InterruptNumber;
use cortex_m::peripheral::NVIC;
use cortex_m_rt::exception;
use critical_section::Mutex;
use embassy_sync::waitqueue::AtomicWaker;
use embassy_time::{Duration, Instant};
use embedded_io_async::{ErrorType, Read, Write};
use heapless::Deque;

use super::pipe::{self, LINE_RATE, Pipe, Wanted};
use super::uart;

/// Bytes that wait at most; while it is full the port holds the host back.
const WAITING: usize = 1024;

static HEARD: Mutex<RefCell<Deque<u8, WAITING>>> = Mutex::new(RefCell::new(Deque::new()));
static WAKER: AtomicWaker = AtomicWaker::new();

/// The interrupt of the first port's receiver.
#[derive(Clone, Copy)]
struct Heard;

// SAFETY: number 0 is the interrupt `UARTRX0` of this board, and is used for nothing else.
unsafe impl InterruptNumber for Heard {
    fn number(self) -> u16 {
        0
    }
}

/// Listens from now on.
pub(super) fn start() {
    uart::LINK.interrupt(true);
    // SAFETY: the handler touches nothing outside critical sections.
    unsafe { NVIC::unmask(Heard) };
}

/// Hears from the host.
pub(crate) enum Ear {
    /// By the serial port.
    Serial,
    /// By a pipe.
    Pipe(Pipe),
    /// By a pipe that brings the next bytes at this time.
    Line(Pipe, Instant),
}

/// Speaks to the host.
pub(crate) enum Mouth {
    /// By the serial port.
    Serial,
    /// By a pipe.
    Pipe(Pipe),
}

/// Both ends.
pub(super) fn open() -> (Ear, Mouth) {
    match pipe::wanted() {
        Wanted::Serial => (Ear::Serial, Mouth::Serial),
        Wanted::AtOnce => (Ear::Pipe(Pipe::input()), Mouth::Pipe(Pipe::output())),
        Wanted::AsByLine => (Ear::Line(Pipe::input(), Instant::now()), Mouth::Pipe(Pipe::output())),
    }
}

/// Sends last words.
pub(super) fn cry(bytes: &[u8]) {
    match pipe::wanted() {
        Wanted::Serial => uart::LINK.send(bytes),
        _ => Pipe::output().write(bytes),
    }
}

impl ErrorType for Ear {
    type Error = Infallible;
}

impl ErrorType for Mouth {
    type Error = Infallible;
}

impl Read for Ear {
    /// Waits for a byte, then takes what is there.
    async fn read(&mut self, room: &mut [u8]) -> Result<usize, Infallible> {
        match self {
            Self::Serial => Ok(heard(room).await),
            Self::Pipe(pipe) => Ok(pipe.read(room)),
            Self::Line(pipe, next) => {
                reached(*next).await;
                let count = pipe.read(room);
                *next += Duration::from_micros(count as u64 * 1_000_000 / LINE_RATE);
                Ok(count)
            }
        }
    }
}

impl Write for Mouth {
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

/// Waits for a time.
///
/// The executor's own idling, `wfe`, is no sleep for QEMU: time would pass a few instructions at a time.
async fn reached(time: Instant) {
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

/// Waits for bytes of the serial port.
async fn heard(room: &mut [u8]) -> usize {
    let count = poll_fn(|context| {
        WAKER.register(context.waker());
        match take(room) {
            0 => Poll::Pending,
            count => Poll::Ready(count),
        }
    });
    count.await
}

fn take(room: &mut [u8]) -> usize {
    critical_section::with(|cs| {
        let mut heard = HEARD.borrow_ref_mut(cs);
        let mut count = 0;
        while let Some((place, byte)) = room.get_mut(count).and_then(|place| Some((place, heard.pop_front()?))) {
            *place = byte;
            count += 1;
        }
        uart::LINK.interrupt(true);
        count
    })
}

// SAFETY: an exception handler of its own number; it touches nothing outside critical sections.
#[exception]
unsafe fn DefaultHandler(_interrupt: i16) {
    critical_section::with(|cs| {
        let mut heard = HEARD.borrow_ref_mut(cs);
        uart::LINK.seen();
        while !heard.is_full() {
            let Some(byte) = uart::LINK.hear() else { break };
            let _ = heard.push_back(byte);
        }
        if heard.is_full() {
            uart::LINK.interrupt(false);
        }
    });
    WAKER.wake();
}
