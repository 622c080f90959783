#![no_std]
#![no_main]

#[expect(dead_code, reason = "this program measures no costs")]
mod clock;

use bica::prelude::*;
use bica::runner::{OverrunPolicy, Schedule};
use cortex_m_semihosting::{debug, hprintln};
use embassy_executor::Spawner;
use panic_semihosting as _;
use static_cell::ConstStaticCell;

pub struct Distance {
    metres: f32,
}

#[component(hz = 50)]
impl Distance {
    pub const fn new() -> Self {
        Self { metres: 2.0 }
    }

    /// Simulates a sensor: the distance to a wall shrinks by 1 m/s.
    fn step(&mut self) {
        self.metres -= 0.02;
    }
}

pub struct Wheels {
    speed: f32,
}

#[component]
impl Wheels {
    pub const fn new() -> Self {
        Self { speed: 0.0 }
    }
}

pub struct Drive;

#[component(hz = 20)]
impl Drive {
    pub const fn new() -> Self {
        Self
    }

    /// Drives.
    #[state(initial)]
    fn go(&mut self, wheels: &mut Wheels) {
        wheels.speed = 0.5;
    }

    /// Stops before the wall.
    #[state(last)]
    fn halt(&mut self, wheels: &mut Wheels) {
        wheels.speed = 0.0;
    }

    #[transition(go -> halt)]
    fn is_near(&self, distance: &Distance) -> bool {
        distance.metres < 1.0
    }
}

activation_tree! {
    pub struct Robot { root: Drive, cycle_hz: 100, components: [Drive, Distance, Wheels] }
}

static ROBOT: ConstStaticCell<Robot> = ConstStaticCell::new(Robot::new());

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    clock::start();
    let robot = ROBOT.take();
    let mut schedule = Schedule::new(Robot::GRAPH.cycle_hz, OverrunPolicy::Skip);
    for _ in 0..150 {
        schedule.wait().await;
        schedule.begin(Instant::now());
        robot.tick(Instant::now());
        schedule.end(Instant::now());
        if robot.get::<Wheels>().speed == 0.0 {
            hprintln!("halted at {} ms", Instant::now().as_millis());
            debug::exit(debug::EXIT_SUCCESS);
        }
    }
    panic!("never halted");
}
