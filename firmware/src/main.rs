//! The forward on a microcontroller.
//!
//! The microcontroller thinks; the world is on the other end of a serial line, and speaks `bica-wire`. There is no heap:
//! the image does not link as soon as anything in it allocates.
#![no_std]
#![no_main]

mod an500;
mod board;
mod meter;
mod mind;
mod reason;
mod stack;
mod voice;

use core::panic::PanicInfo;

use bica::Tree;
use bica_motion::joints::Joints;
use bica_motion::robot::{self, CameraId, Lights};
use bica_player::Forward;
use bica_player::input::{EYE_BYTES, Eye};
use bica_wire::message::{Command, Pace};
use bica_wire::{Frame, FromRobot, MAX_PACKET, Receiver, Sender, ToRobot};
use embassy_executor::Spawner;
use embassy_futures::select::{Either, select};
use embassy_time::{Duration, Instant, Ticker};
use embedded_io_async::Read;
use static_cell::ConstStaticCell;

use an500::{An500, Ear, Mouth};
use board::Board;
use mind::Mind;
use voice::Voice;

static ROBOT: ConstStaticCell<Forward> = ConstStaticCell::new(Forward::new());
static EYE: ConstStaticCell<[u8; EYE_BYTES]> = ConstStaticCell::new([0; EYE_BYTES]);
static FRAME: ConstStaticCell<Frame<EYE_BYTES>> = ConstStaticCell::new(Frame::new());
static RECEIVER: ConstStaticCell<Receiver<MAX_PACKET>> = ConstStaticCell::new(Receiver::new());

/// Starts the board, then the mind.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    stack::paint();
    let (ear, mouth) = An500::start().link();
    let past = reason::past();
    if past.restarts > 0 {
        defmt::error!("started anew, {=u32} times by now: {=str}", past.restarts, past.reason.as_str());
    }
    let robot = ROBOT.take();
    robot.get_mut::<Eye>().lend(EYE.take());
    spawner.spawn(live(ear, Voice::new(mouth), Mind::new(robot, FRAME.take(), past)).expect("one mind"));
}

/// Hears and ticks, forever.
#[embassy_executor::task]
async fn live(mut ear: Ear, mut voice: Voice<Mouth>, mut mind: Mind<An500>) {
    let receiver = RECEIVER.take();
    let period = Duration::from_hz(Forward::GRAPH.cycle_hz as u64);
    let mut ticker = Ticker::every(period);
    let mut room = [0; 256];
    voice.say(&mind.greeting()).await;
    let mut due = Instant::now() + period;
    loop {
        if mind.pace() != Some(Pace::Clock) {
            let Ok(count) = ear.read(&mut room).await;
            listen(&room[..count], receiver, &mut mind, &mut voice).await;
            ticker.reset();
            due = Instant::now() + period;
            continue;
        }
        // The ear first: late cycles, always due, must not make it deaf.
        match select(ear.read(&mut room), ticker.next()).await {
            Either::First(Ok(count)) => listen(&room[..count], receiver, &mut mind, &mut voice).await,
            Either::Second(()) => {
                mind.tick(due, receiver.losses(), &mut voice).await;
                due += period;
            }
        }
    }
}

async fn listen(bytes: &[u8], receiver: &mut Receiver<MAX_PACKET>, mind: &mut Mind<An500>, voice: &mut Voice<Mouth>) {
    for &byte in bytes {
        let losses = receiver.losses();
        if let Some(heard) = receiver.push(byte) {
            match heard.read::<ToRobot<'_>>() {
                Ok(message) => mind.hear(&message, losses, voice).await,
                Err(_) => defmt::warn!("a packet that is no message"),
            }
        }
    }
}

/// Makes the motors safe, keeps the reason, starts anew.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    cortex_m::interrupt::disable();
    let limp = robot::Command {
        targets: Joints::all(0.0),
        stiffness: Joints::all(0.0),
        lights: Lights::default(),
        camera: CameraId::default(),
    };
    let mut room = [0; MAX_PACKET];
    // A zero ends whatever packet the panic cut in two.
    An500::cry(&[0]);
    if let Ok(packet) = Sender::new().pack(&FromRobot::Command(Command::new(u64::MAX, &limp)), &mut room) {
        An500::cry(packet);
    }
    reason::keep(info);
    An500::reset()
}
