//! The robot's task: receives messages and ticks the tree.

use bica::Tree;
use bica::runner::{OverrunPolicy, Schedule};
#[cfg(feature = "monitor")]
use bica_player::input::Colours;
#[cfg(feature = "monitor")]
use bica_vision::table::GradualTable;
use bica_wire::message::ClockMode;
#[cfg(feature = "monitor")]
use bica_wire::server::SerialLine;
use bica_wire::{Decoder, MAX_PACKET, ToRobot};
use embassy_futures::select::{Either, select};
#[cfg(feature = "monitor")]
use embassy_time::Duration;
use embassy_time::{Instant, Timer};
use embedded_io_async::Read;
use static_cell::ConstStaticCell;

use crate::board::{Board, Links};
use crate::controller::Controller;
use crate::crash_log::{self, CrashLog};
use crate::image::ImageReceiver;
#[cfg(feature = "monitor")]
use crate::init;
use crate::init::Robot;
use crate::link::MessageTx;
#[cfg(feature = "monitor")]
use crate::monitor_line;
use crate::tree::Forward;

static DECODER: ConstStaticCell<Decoder<MAX_PACKET>> = ConstStaticCell::new(Decoder::new());
static PACKET: ConstStaticCell<[u8; MAX_PACKET]> = ConstStaticCell::new([0; MAX_PACKET]);
#[cfg(feature = "monitor")]
static MONITOR_LINE: ConstStaticCell<SerialLine> = ConstStaticCell::new(SerialLine::new(monitor_line::MONITOR));
/// Memory of the colour classes that an operator adjusts.
#[cfg(feature = "monitor")]
static COLOURS: ConstStaticCell<GradualTable> = ConstStaticCell::new(GradualTable::new());

/// Largest number of times that the monitors' line is served after bytes from the body, while no clock runs.
#[cfg(feature = "monitor")]
const MOST_SERVED: usize = 16;

/// Longest time between two services of the monitors' line while no clock runs.
#[cfg(feature = "monitor")]
const SERVED: Duration = Duration::from_millis(10);

/// Size of the buffer for received bytes.
const RX_BYTES: usize = 256;

/// Receives messages and ticks the tree, forever. Called once.
///
/// The loop is not `Runner::run_async`: in lockstep a message is the clock, and in free-running mode messages are handled
/// between the ticks. The deadlines are those of all loops, [`Schedule`]: ones that are at least a period old are skipped and counted.
///
/// # Panics
/// If it is called twice.
pub async fn run<B: Board>(Robot(robot): Robot, links: Links<B>) -> ! {
    let (mut rx, tx) = links.body;
    #[cfg(feature = "monitor")]
    let ((mut monitor_rx, mut monitor_tx), line) = (links.monitor, MONITOR_LINE.take());
    #[cfg(feature = "monitor")]
    robot.get_mut::<Colours>().set_memory(COLOURS.take());
    let decoder = DECODER.take();
    let mut tx = MessageTx::new(tx, PACKET.take());
    let mut controller = Controller::<B>::new(
        robot,
        ImageReceiver::new(),
        read_crash_log(),
        #[cfg(feature = "monitor")]
        init::monitors(),
    );
    let mut schedule = Schedule::new(Forward::GRAPH.cycle_hz, OverrunPolicy::Skip);
    let mut buffer = [0; RX_BYTES];
    tx.send(&controller.identity()).await;
    loop {
        if controller.clock_mode() != Some(ClockMode::FreeRunning) {
            #[cfg(not(feature = "monitor"))]
            let count = rx.read(&mut buffer).await.unwrap_or(0);
            #[cfg(feature = "monitor")]
            let count = match select(rx.read(&mut buffer), Timer::after(SERVED)).await {
                Either::First(count) => count.unwrap_or(0),
                Either::Second(()) => 0,
            };
            receive(&buffer[..count], decoder, &mut controller, &mut tx).await;
            // No clock runs that this could delay.
            #[cfg(feature = "monitor")]
            for _ in 0..MOST_SERVED {
                if !monitor_line::serve(line, &mut monitor_rx, &mut monitor_tx, &mut controller) {
                    break;
                }
            }
            schedule.restart();
            continue;
        }
        // The receiver is polled first: a late cycle, which is always due, must not block it.
        match select(rx.read(&mut buffer), due(&mut schedule)).await {
            Either::First(count) => receive(&buffer[..count.unwrap_or(0)], decoder, &mut controller, &mut tx).await,
            Either::Second(()) => {
                schedule.begin(Instant::now());
                controller.tick(schedule.skipped, decoder.stats(), &mut tx).await;
                schedule.end(Instant::now());
                #[cfg(feature = "monitor")]
                monitor_line::serve(line, &mut monitor_rx, &mut monitor_tx, &mut controller);
            }
        }
    }
}

/// Waits for the next deadline. Unlike [`Schedule::wait`], it does not yield if that has passed: a late loop whose receiver always has
/// bytes would never be polled again.
async fn due(schedule: &mut Schedule) {
    let deadline = schedule.deadline(Instant::now());
    if Instant::now() < deadline {
        Timer::at(deadline).await;
    }
}

fn read_crash_log() -> CrashLog {
    let log = crash_log::read();
    if log.restarts > 0 {
        defmt::error!("restart {=u32} after a panic: {=str}", log.restarts, log.last_panic.as_str());
    }
    log
}

async fn receive<B: Board>(
    bytes: &[u8],
    decoder: &mut Decoder<MAX_PACKET>,
    controller: &mut Controller<B>,
    tx: &mut MessageTx<B::Tx>,
) {
    for &byte in bytes {
        let stats = decoder.stats();
        if let Some(packet) = decoder.push(byte) {
            if let Ok(message) = packet.message::<ToRobot<'_>>() {
                controller.receive(&message, stats, tx).await;
            } else {
                defmt::warn!("a packet contains no message of this schema");
            }
        }
    }
}
