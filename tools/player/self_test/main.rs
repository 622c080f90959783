//! The test program of the firmware image, run by `cargo xtask firmware`.
//!
//! It plays a game in which every cycle is computed on the host and on the emulated microcontroller, checks the robot's
//! reactions to faults, and compares size, memory and instruction counts with limits and committed figures.

mod figures;
mod game;
mod images;
mod limits;
mod link_fuzz;
mod log;
mod monitors;
mod overload;
mod parts;
mod random;
mod reference;
mod scenarios;
mod sequences;
mod session;
mod size;
mod throughput;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::thread;
use std::time::Duration;

use bica_player_program::emulator::Transport;
use bica_sim::setup::Frame;

use limits::Limits;

const USAGE: &str = "firmware-test IMAGE FIGURES [--size | --bless | --monitors | --fuzz SECONDS [SEED]]";

/// Time limit of the whole test. A silent emulator would block it forever.
const TIMEOUT: Duration = Duration::from_mins(30);

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let number = |text: &str| text.parse::<u64>().map_err(|error| format!("{text}: {error}").into());
    let result = match arguments[..] {
        [image, _, "--size"] => size::print(Path::new(image)),
        [image, figures, "--bless"] => test(Path::new(image), Path::new(figures), true),
        [image, figures, "--monitors"] => test_monitors(Path::new(image), Path::new(figures)),
        [image, figures] => test(Path::new(image), Path::new(figures), false),
        [image, _, "--fuzz", seconds] => number(seconds).and_then(|seconds| fuzz(Path::new(image), seconds, 0)),
        [image, _, "--fuzz", seconds, seed] => {
            number(seconds).and_then(|seconds| fuzz(Path::new(image), seconds, number(seed)?))
        }
        _ => Err(USAGE.into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("firmware-test: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Runs all tests of an image without the server for monitors. `bless` writes the instruction counts of this game
/// instead of comparing them.
fn test(image: &Path, figures: &Path, bless: bool) -> Result<(), Box<dyn Error>> {
    limit_time();
    let frame = session::frame(image)?;
    let played = game::play(image, 0, frame)?;
    let lines = log::decode(image, &played.log)?;
    for line in &lines {
        println!("log: {line}");
    }
    println!("{} cycles, goal after {:.2} s; every command equals the host's", played.cycles, played.goal_s);
    limits::check(&size::sections(image)?, &played, &Limits::of(frame, false))?;
    throughput::check(image, frame, &played)?;
    for expected in ["look_for_ball -> approach", "visible: ball true, goal true"] {
        if !lines.iter().any(|line| line.contains(expected)) {
            return Err(format!("the log does not contain: {expected}").into());
        }
    }
    parts::run_all(parts::list(image, frame))?;
    if bless { figures::write(figures, &played) } else { figures::compare(figures, &played) }
}

/// Tests the image with the server for monitors: its game must equal the host's and stay within separate limits.
fn test_monitors(image: &Path, figures: &Path) -> Result<(), Box<dyn Error>> {
    limit_time();
    let played = game::play(image, 0, Frame::Small)?;
    println!("{} cycles with the tunable tree; every command equals the host's", played.cycles);
    limits::check(&size::sections(image)?, &played, &Limits::of(Frame::Small, true))?;
    figures::compare_chain(figures, &played)?;
    parts::run_all(monitors::list(image))
}

/// Ends the program with an error after `TIMEOUT`.
fn limit_time() {
    thread::spawn(|| {
        thread::sleep(TIMEOUT);
        eprintln!("firmware-test: not finished after {TIMEOUT:?}");
        std::process::exit(1);
    });
}

/// Fuzzes the link to the image for a time.
fn fuzz(image: &Path, seconds: u64, seed: u64) -> Result<(), Box<dyn Error>> {
    let time = Duration::from_secs(seconds);
    println!("fuzz: link by pipe: {}", link_fuzz::run(image, Transport::Pipe, time, seed)?);
    Ok(())
}
