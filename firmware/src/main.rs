//! The forward on a microcontroller.
//!
//! The microcontroller thinks; the world is on the other end of a serial line, and speaks `bica-wire`. There is no heap:
//! the image does not link as soon as anything in it allocates.
#![no_std]
#![no_main]

mod an500;
mod board;
mod life;
mod meter;
mod mind;
mod reason;
mod stack;
mod voice;

use core::panic::PanicInfo;

use embassy_executor::Spawner;

use an500::{An500, Ear, Mouth};
use board::Board;

/// Starts the board, then the robot.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    stack::paint();
    let (ear, mouth) = An500::start().link();
    spawner.spawn(robot(ear, mouth).expect("one robot"));
}

/// The robot.
#[embassy_executor::task]
async fn robot(ear: Ear, mouth: Mouth) {
    life::live::<An500>(ear, mouth).await
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    life::end::<An500>(info)
}
