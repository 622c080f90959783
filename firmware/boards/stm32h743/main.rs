//! The forward on an STM32H743. It compiles, but it has never run on the chip.
//!
//! Before use, check clock, pins and serial port against the board.
#![no_std]
#![no_main]

mod board;

use core::panic::PanicInfo;

use bica_firmware::{Board, Links, Robot};
use defmt_rtt as _;
use embassy_executor::Spawner;

use board::Stm32h743;

/// Starts the board, then the robot's task.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let forward = bica_firmware::init();
    let links = Stm32h743::start().links();
    spawner.spawn(robot(forward, links).expect("spawned once"));
}

/// The robot's task.
#[embassy_executor::task]
async fn robot(forward: Robot, links: Links<Stm32h743>) {
    bica_firmware::run(forward, links).await
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    bica_firmware::handle_panic::<Stm32h743>(info)
}
