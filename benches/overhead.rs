//! Runs empty sections, and then a recording in which the forward walks towards the ball; `benches/scripts/overhead.py` observes it
//! by callgrind.
//!
//! A probe calls a function before and another one after each section of a component's own code.

use std::hint::black_box;

use bica::prelude::*;
use bica::runner::Robot;
use bica_benches::recording::{CYCLES, Recording, WARM};
use bica_player::Forward;
use bica_player::perception::Localization;
use bica_sim::setup::Frame;

/// Number of cycles until the tree has settled after a hold is released.
const SETTLING: usize = 5;
/// Number of empty sections, which measure the cost of the probe's calls.
const EMPTY: u64 = 1000;

// Two equal functions would become one.
#[inline(never)]
fn section_begins() {
    black_box(1);
}

#[inline(never)]
fn section_ends() {
    black_box(2);
}

struct Sections;

impl Probe for Sections {
    fn begin(&mut self, _: ComponentId) {
        section_begins();
    }

    fn end(&mut self, _: ComponentId) {
        section_ends();
    }
}

#[inline(never)]
fn counted_tick(robot: &mut Forward, now: Instant) {
    robot.tick_with(now, &mut Sections);
}

#[inline(never)]
fn counted_calls() {
    for _ in 0..EMPTY {
        section_begins();
        section_ends();
    }
}

fn main() {
    let (recording, mut robot) = Recording::of_game::<Forward>(Frame::Small, WARM, CYCLES);
    robot.of_mut::<Localization>().hold(Hold::Tree);
    counted_calls();
    println!("{EMPTY} {}", CYCLES - SETTLING);
    for (cycle, sensors) in recording.sensors().enumerate() {
        robot.sense(&sensors).expect("the image fits");
        let now = Instant::from_millis(10_000 + 10 * cycle as u64);
        if cycle < SETTLING {
            robot.tick(now);
        } else {
            counted_tick(&mut robot, now);
        }
    }
}
