//! What `cargo xtask firmware` runs: games of which every cycle is thought twice, here and on the emulated
//! microcontroller; trials of what it does when things go wrong; and what the image costs, held against limits and
//! against what it cost before.

mod figures;
mod fuzz;
mod game;
mod limits;
mod log;
mod overload;
mod random;
mod sequences;
mod size;
mod trials;
mod twin;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use bica_emulator::Carrier;

const USAGE: &str = "self_test IMAGE FIGURES [--size | --bless | --fuzz SECONDS [SEED]]";

/// How long the link is damaged in every test; `--fuzz` takes longer.
const FUZZ: Duration = Duration::from_secs(10);

/// After this time something hangs: an emulator that says nothing would be waited for forever.
const HANGS: Duration = Duration::from_mins(30);

/// A part of the test: its name, and what does it and tells what it found.
type Part<'a> = (String, Box<dyn FnOnce() -> Result<String, Box<dyn Error>> + Send + 'a>);

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let number = |word: &str| word.parse::<u64>().map_err(|error| format!("{word}: {error}").into());
    let done = match words[..] {
        [image, _, "--size"] => size::tell(Path::new(image)),
        [image, figures, "--bless"] => test(Path::new(image), Path::new(figures), true),
        [image, figures] => test(Path::new(image), Path::new(figures), false),
        [image, _, "--fuzz", seconds] => number(seconds).and_then(|seconds| fuzz(Path::new(image), seconds, 0)),
        [image, _, "--fuzz", seconds, seed] => {
            number(seconds).and_then(|seconds| fuzz(Path::new(image), seconds, number(seed)?))
        }
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
    thread::spawn(|| {
        thread::sleep(HANGS);
        eprintln!("self-test: not done after {HANGS:?}");
        std::process::exit(1);
    });
    let played = game::play(image, 0)?;
    let lines = log::decode(image, &played.log)?;
    for line in &lines {
        println!("log: {line}");
    }
    println!("{} cycles, a goal after {:.2} s; every command is the host's, bit for bit", played.cycles, played.goal_s);
    let sections = size::sections(image)?;
    limits::check(&sections, &played)?;
    for wanted in ["look_for_ball -> approach", "in sight: ball true, goal true"] {
        if !lines.iter().any(|line| line.contains(wanted)) {
            return Err(format!("the log does not tell: {wanted}").into());
        }
    }
    all(parts(image))?;
    if bless { figures::write(figures, &played) } else { figures::compare(figures, &played) }
}

/// All that is tried beside the game.
fn parts(image: &Path) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = Vec::new();
    for sequence in &sequences::ALL {
        let think = move || Ok(format!("{} cycles, bit for bit the host's", sequence.think(image)?));
        parts.push((format!("sequence: {}", sequence.name), Box::new(think)));
    }
    for (name, carrier, trial) in trials::ALL {
        parts.push((format!("trial: {name}"), Box::new(move || trial(image, carrier).map(|()| "so it is".to_owned()))));
    }
    for (name, carrier) in [("by pipe", Carrier::Pipe), ("by the serial port", Carrier::Serial)] {
        parts.push((format!("fuzz: {name}"), Box::new(move || fuzz::run(image, carrier, FUZZ, 0))));
    }
    parts
}

/// Does everything, two parts at a time; the first that fails ends it.
fn all(parts: Vec<Part<'_>>) -> Result<(), Box<dyn Error>> {
    let queue = Mutex::new(parts.into_iter());
    let work = || -> Result<(), String> {
        loop {
            let next = queue.lock().map_err(|error| error.to_string())?.next();
            let Some((name, part)) = next else { return Ok(()) };
            let found = part().map_err(|error| format!("not so: {name}: {error}"))?;
            println!("{name}: {found}");
        }
    };
    thread::scope(|scope| {
        let workers = [scope.spawn(work), scope.spawn(work)];
        for worker in workers {
            worker.join().map_err(|_| "a part panicked")??;
        }
        Ok(())
    })
}

/// Damages the link for so long.
fn fuzz(image: &Path, seconds: u64, seed: u64) -> Result<(), Box<dyn Error>> {
    println!("{}", fuzz::run(image, Carrier::Pipe, Duration::from_secs(seconds), seed)?);
    Ok(())
}
