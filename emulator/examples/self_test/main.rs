//! What `cargo xtask firmware` runs: a game of which every cycle is thought twice, here and on the emulated
//! microcontroller; and what the image costs, held against limits and against what it cost before.

mod figures;
mod game;
mod limits;
mod log;
mod size;
mod trials;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "self_test IMAGE FIGURES [--size | --bless]";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words[..] {
        [image, _, "--size"] => size::tell(Path::new(image)),
        [image, figures, "--bless"] => test(Path::new(image), Path::new(figures), true),
        [image, figures] => test(Path::new(image), Path::new(figures), false),
        _ => Err(USAGE.into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("self-test: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Plays, and judges; `bless` takes the costs of this game as the ones to compare with.
fn test(image: &Path, figures: &Path, bless: bool) -> Result<(), Box<dyn Error>> {
    let played = game::play(image, 0)?;
    let lines = log::decode(image, &played.log)?;
    for line in &lines {
        println!("log: {line}");
    }
    println!("{} cycles, a goal after {:.2} s; every command is the host's, bit for bit", played.cycles, played.goal_s);
    let sections = size::sections(image)?;
    limits::check(&sections, &played)?;
    if !lines.iter().any(|line| line.contains("look_for_ball -> approach")) {
        return Err("the log tells of no change of state".into());
    }
    trials::run(image)?;
    if bless { figures::write(figures, &played) } else { figures::compare(figures, &played) }
}
