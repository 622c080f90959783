//! The forward on the board mps2-an500, as QEMU emulates it.
#![no_std]
#![no_main]

mod board;
mod clock;
mod log;
#[cfg_attr(not(feature = "monitor"), path = "no_monitor.rs")]
mod monitor;
mod pipe;
mod transport;
mod uart;

use core::panic::PanicInfo;

use bica_firmware::{Board, Links, Robot};
use embassy_executor::Spawner;

use board::An500;

/// Starts the board, then the robot's task.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let forward = bica_firmware::init();
    let links = An500::start().links();
    spawner.spawn(robot(forward, links).expect("spawned once"));
}

/// The robot's task.
#[embassy_executor::task]
async fn robot(forward: Robot, links: Links<An500>) {
    bica_firmware::run(forward, links).await;
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    bica_firmware::handle_panic::<An500>(info)
}
