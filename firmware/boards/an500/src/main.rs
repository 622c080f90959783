//! The forward on the board mps2-an500, as QEMU emulates it.
#![no_std]
#![no_main]

mod board;
mod clock;
mod log;
mod pipe;
mod transport;
mod uart;

use core::panic::PanicInfo;

use bica_firmware::{Board, Robot};
use embassy_executor::Spawner;

use board::An500;
use transport::{Rx, Tx};

/// Starts the board, then the robot's task.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let forward = bica_firmware::init();
    let (rx, tx) = An500::start().link();
    spawner.spawn(robot(forward, rx, tx).expect("spawned once"));
}

/// The robot's task.
#[embassy_executor::task]
async fn robot(forward: Robot, rx: Rx, tx: Tx) {
    bica_firmware::run::<An500>(forward, rx, tx).await
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    bica_firmware::handle_panic::<An500>(info)
}
