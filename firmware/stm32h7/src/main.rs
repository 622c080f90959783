//! The forward on an STM32H743: a skeleton that compiles and was never run.
//!
//! All but the board is the code of `firmware/src`. A user of it checks clock, pins and serial port against the board.
#![no_std]
#![no_main]

#[path = "../../src/board.rs"]
mod board;
mod h743;
#[path = "../../src/life.rs"]
mod life;
#[path = "../../src/meter.rs"]
mod meter;
#[path = "../../src/mind.rs"]
mod mind;
#[path = "../../src/reason.rs"]
mod reason;
#[path = "../../src/stack.rs"]
mod stack;
#[path = "../../src/voice.rs"]
mod voice;

use core::panic::PanicInfo;

use defmt_rtt as _;
use embassy_executor::Spawner;
use embassy_stm32::usart::{BufferedUartRx, BufferedUartTx};

use board::Board;
use h743::H743;

/// Starts the board, then the robot.
#[embassy_executor::main]
async fn main(spawner: Spawner) {
    stack::paint();
    let (ear, mouth) = H743::start().link();
    spawner.spawn(robot(ear, mouth).expect("one robot"));
}

/// The robot.
#[embassy_executor::task]
async fn robot(ear: BufferedUartRx<'static>, mouth: BufferedUartTx<'static>) {
    life::live::<H743>(ear, mouth).await
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    life::end::<H743>(info)
}
