//! From the start to the end: the robot's one task, and its last words.

use core::fmt::Display;

use bica::Tree;
use bica_motion::joints::Joints;
use bica_motion::robot::{self, CameraId, Lights};
use bica_player::Forward;
use bica_player::input::{CameraInput, IMAGE_BYTES};
use bica_wire::message::{ClockMode, Command};
use bica_wire::{Decoder, Encoder, FromRobot, ImageBuffer, MAX_PACKET, ToRobot};
use embassy_futures::select::{Either, select};
use embassy_time::{Duration, Instant, Ticker};
use embedded_io_async::Read;
use static_cell::ConstStaticCell;

use crate::board::Board;
use crate::mind::Mind;
use crate::reason;
use crate::voice::Voice;

static ROBOT: ConstStaticCell<Forward> = ConstStaticCell::new(Forward::new());
static EYE: ConstStaticCell<[u8; IMAGE_BYTES]> = ConstStaticCell::new([0; IMAGE_BYTES]);
static FRAME: ConstStaticCell<ImageBuffer<IMAGE_BYTES>> = ConstStaticCell::new(ImageBuffer::new());
static RECEIVER: ConstStaticCell<Decoder<MAX_PACKET>> = ConstStaticCell::new(Decoder::new());
static PACKET: ConstStaticCell<[u8; MAX_PACKET]> = ConstStaticCell::new([0; MAX_PACKET]);

/// Room for the packet of a command, bytes: 250 at most, and what stuffing adds.
const LAST_WORDS: usize = 320;

/// Hears and ticks, forever. Called once.
pub(crate) async fn live<B: Board>(mut ear: B::Ear, mouth: B::Mouth) -> ! {
    let (receiver, robot) = (RECEIVER.take(), ROBOT.take());
    robot.get_mut::<CameraInput>().set_buffer(EYE.take());
    let (mut voice, mut mind) = (Voice::new(mouth, PACKET.take()), Mind::<B>::new(robot, FRAME.take(), past()));
    let period = Duration::from_hz(Forward::GRAPH.cycle_hz as u64);
    let mut ticker = Ticker::every(period);
    let mut due = Instant::now() + period;
    let mut room = [0; 256];
    voice.say(&mind.greeting()).await;
    loop {
        if mind.pace() != Some(ClockMode::FreeRunning) {
            let count = ear.read(&mut room).await.unwrap_or(0);
            listen(&room[..count], receiver, &mut mind, &mut voice).await;
            ticker.reset();
            due = Instant::now() + period;
            continue;
        }
        // The ear first: late cycles, always due, must not make it deaf.
        match select(ear.read(&mut room), ticker.next()).await {
            Either::First(count) => listen(&room[..count.unwrap_or(0)], receiver, &mut mind, &mut voice).await,
            Either::Second(()) => {
                mind.tick(due, receiver.stats(), &mut voice).await;
                due += period;
            }
        }
    }
}

fn past() -> reason::Past {
    let past = reason::past();
    if past.restarts > 0 {
        defmt::error!("restart {=u32} after a panic: {=str}", past.restarts, past.reason.as_str());
    }
    past
}

async fn listen<B: Board>(
    bytes: &[u8],
    receiver: &mut Decoder<MAX_PACKET>,
    mind: &mut Mind<B>,
    voice: &mut Voice<B::Mouth>,
) {
    for &byte in bytes {
        let losses = receiver.stats();
        if let Some(heard) = receiver.push(byte) {
            match heard.message::<ToRobot<'_>>() {
                Ok(message) => mind.hear(&message, losses, voice).await,
                Err(_) => defmt::warn!("a packet that is no message"),
            }
        }
    }
}

/// Makes the motors safe, keeps the reason, starts anew.
pub(crate) fn end<B: Board>(reason: impl Display) -> ! {
    cortex_m::interrupt::disable();
    let limp = robot::Command {
        targets: Joints::all(0.0),
        stiffness: Joints::all(0.0),
        lights: Lights::default(),
        camera: CameraId::default(),
    };
    let mut room = [0; LAST_WORDS];
    // A zero ends whatever packet the panic cut in two.
    B::cry(&[0]);
    if let Ok(packet) = Encoder::new().encode(&FromRobot::Command(Command::new(u64::MAX, &limp)), &mut room) {
        B::cry(packet);
    }
    reason::keep(reason);
    B::reset()
}
