//! Instructions of the forward's tick beyond its steps: the cost of the framework.
//!
//! `cargo run --profile bench --package bica-benches --example overhead` observes itself by callgrind. A probe calls a
//! function before and another one after each section of a component's own code, and callgrind reports the instructions
//! since its last report whenever one of them is entered.

use std::hint::black_box;
use std::process::Command;
use std::{env, fs};

use bica::prelude::*;
use bica::runner::Robot;
use bica_benches::recording::{CYCLES, Recording, WARM};
use bica_player::Forward;
use bica_player::perception::Localization;
use bica_sim::setup::Frame;

/// Argument of the observed process.
const OBSERVED: &str = "observed";
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

/// Runs the empty sections, and then a recording in which the robot walks towards the ball.
fn observed() {
    let (recording, mut robot) = Recording::of_game::<Forward>(Frame::Small, WARM, CYCLES);
    robot.hold::<Localization>(Hold::Tree);
    counted_calls();
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

/// Returns the counts between a section's end and the next one's begin.
fn outside(report: &str) -> Vec<u64> {
    let mut is_outside = true;
    let mut counts = Vec::new();
    for line in report.lines() {
        if line.starts_with("desc: Trigger: ") {
            is_outside = !line.ends_with("section_ends");
        } else if let Some(count) = line.strip_prefix("summary: ").filter(|_| is_outside) {
            counts.push(count.trim().parse().expect("a count of instructions"));
        }
    }
    counts
}

fn main() {
    if env::args().nth(1).is_some_and(|word| word == OBSERVED) {
        return observed();
    }
    let report = env::temp_dir().join(format!("overhead-{}", std::process::id()));
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--combine-dumps=yes", "--collect-atstart=no"])
        .args(["--toggle-collect=*counted_*", "--dump-before=*section_begins*", "--dump-before=*section_ends*"])
        .arg(format!("--callgrind-out-file={}", report.display()))
        .arg(env::current_exe().expect("the path of this program"))
        .arg(OBSERVED)
        .status();
    assert!(
        status.is_ok_and(|status| status.success()),
        "valgrind is not installed, or failed: `apt-get install valgrind`"
    );
    let counts = outside(&fs::read_to_string(&report).expect("valgrind's report"));
    fs::remove_file(&report).expect("valgrind's report can be removed");
    let (empty, ticks) = counts.split_at(EMPTY as usize);
    let call = empty.iter().sum::<u64>() / EMPTY;
    let (cycles, sections) = ((CYCLES - SETTLING) as u64, ticks.len() as u64 - 1);
    assert!(sections > cycles, "valgrind reported {sections} sections in {cycles} cycles");
    let beyond = ticks.iter().sum::<u64>() - call * sections;
    println!("forward: {} instructions beyond {} sections of steps in a tick", beyond / cycles, sections / cycles);
}
